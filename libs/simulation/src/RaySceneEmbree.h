#pragma once

#include <bslnav/simulation/RayScene.h>
#include <embree3/rtcore.h>

#include <memory>
#include <vector>

#include "PersonCylinder.h"

namespace bslnav {

/** A handle of the ray caster that is released with its owner. */
template <typename Handle, void (*release)(Handle)>
struct ReleaseHandle {
  void operator()(Handle handle) const { release(handle); }
};
template <typename Handle, void (*release)(Handle)>
using OwnedHandle = std::unique_ptr<std::remove_pointer_t<Handle>, ReleaseHandle<Handle, release>>;

struct RayScene::Embree {
  // Not "threads=1": while such a device lives, TBB has one thread in the whole process.
  OwnedHandle<RTCDevice, rtcReleaseDevice> device{rtcNewDevice(nullptr)};
  OwnedHandle<RTCScene, rtcReleaseScene> solids;
  std::vector<PersonCylinder> people;
};

}  // namespace bslnav
