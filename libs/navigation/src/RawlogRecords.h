#pragma once

#include <mrpt/serialization/CSerializable.h>

#include "RawlogFrames.h"

namespace bslnav {

/** Hands what one object of a log tells to the frames; objects of other classes tell nothing. */
void take(const mrpt::serialization::CSerializable::Ptr& object, RawlogFrames& frames);

}  // namespace bslnav
