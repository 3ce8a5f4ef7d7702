#include <bslnav/blindspot/VoxelClusters.h>
#include <bslnav/config/VectorClones.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

constexpr int kLayerBits = 6;

/** Where the volume lies and how it is cut; lengths in voxels but for `perMetre`. */
struct Volume {
  float perMetre;
  int half, side, lowest, layers;
};

inline int floorOf(float value) {
  const int truncated = static_cast<int>(value);
  return truncated - static_cast<int>(value < static_cast<float>(truncated));
}

/** The points of a row of pixels, and the voxel of each: column · 64 + layer, or −1 outside. */
BSLNAV_VECTOR_CLONES void voxelRow(const float* __restrict depth_m, const float* __restrict columnX,
                                   const float* __restrict columnY, const float* __restrict columnZ,
                                   const float* row, const float* origin, const Volume& volume,
                                   int count, float* __restrict x, float* __restrict y,
                                   float* __restrict z, int* __restrict key) {
  const float rowX = row[0], rowY = row[1], rowZ = row[2];
  const float originX = origin[0], originY = origin[1], originZ = origin[2];
  const float perMetre = volume.perMetre;
  const int half = volume.half, side = volume.side, lowest = volume.lowest, layers = volume.layers;
  for (int u = 0; u < count; ++u) {
    const float d = depth_m[u];
    x[u] = originX + d * (columnX[u] + rowX);
    y[u] = originY + d * (columnY[u] + rowY);
    z[u] = originZ + d * (columnZ[u] + rowZ);
    const int i = floorOf(x[u] * perMetre) + half, j = floorOf(y[u] * perMetre) + half,
              k = floorOf(z[u] * perMetre) - lowest;
    // As unsigned numbers, negative ones are large.
    const int outside =
        static_cast<int>(static_cast<unsigned>(i) >= static_cast<unsigned>(2 * half)) |
        static_cast<int>(static_cast<unsigned>(j) >= static_cast<unsigned>(2 * half)) |
        static_cast<int>(static_cast<unsigned>(k) >= static_cast<unsigned>(layers)) |
        static_cast<int>(!(d > 0.0f));
    key[u] = (((i * side + j) << kLayerBits) + k) | -outside;
  }
}

/** Bits within `reach` of a layer. */
std::uint64_t window(int layer, int reach) {
  const int low = std::max(0, layer - reach), high = std::min(63, layer + reach);
  return (~std::uint64_t{0} >> (63 - high)) & (~std::uint64_t{0} << low);
}

}  // namespace

VoxelClusters::VoxelClusters(const DepthClusterParameters& parameters)
    : parameters_(parameters),
      half_(parameters.reach()),
      lowest_(static_cast<int>(std::floor(parameters.zMin_m / parameters.leaf_m))),
      layers_(parameters.layers()),
      reach_(static_cast<int>(std::ceil(parameters.tolerance_m / parameters.leaf_m - 1e-6))) {
  side_ = 2 * half_ + 2 * reach_;  // a margin, so that neighbours need no check
  blockOf_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), -1);
  const double reachSquared = std::pow(parameters.tolerance_m / parameters.leaf_m, 2);
  for (int dx = 0; dx <= reach_; ++dx)
    for (int dy = dx == 0 ? 1 : -reach_; dy <= reach_; ++dy) {
      const double gapX = std::max(0, dx - 1), gapY = std::max(0, std::abs(dy) - 1);
      if (gapX * gapX + gapY * gapY < reachSquared)
        neighbours_.push_back(
            {static_cast<std::ptrdiff_t>(dx) * side_ + dy, dx <= 1 && std::abs(dy) <= 1});
    }
}

const ClusteredCloud& VoxelClusters::cluster(const std::vector<const DepthFrame*>& frames) {
  clear();
  for (const DepthFrame* frame : frames) add(*frame);
  keepVoxels();
  connect();
  number();
  return cloud_;
}

void VoxelClusters::clear() {
  for (const int column : columns_) blockOf_[static_cast<std::size_t>(column)] = -1;
  columns_.clear();
  voxels_.clear();
  cloud_.points.clear();
}

void VoxelClusters::add(const DepthFrame& frame) {
  const auto count = static_cast<std::size_t>(frame.columns());
  for (auto* values : {&x_, &y_, &z_}) values->resize(count);
  key_.resize(count);
  const auto& column = frame.columnRays();
  const auto& rays = frame.rowRays();
  const float origin[3] = {frame.origin().x, frame.origin().y, frame.origin().z};
  const Volume volume{1.0f / static_cast<float>(parameters_.leaf_m), half_, side_, lowest_,
                      layers_};
  for (int v = 0; v < frame.rows(); ++v) {
    const auto j = static_cast<std::size_t>(v);
    const float row[3] = {rays.x[j], rays.y[j], rays.z[j]};
    voxelRow(frame.depthRow(v), column.x.data(), column.y.data(), column.z.data(), row, origin,
             volume, frame.columns(), x_.data(), y_.data(), z_.data(), key_.data());
    addRow(frame.columns());
  }
}

/** Neighbouring pixels are mostly of one voxel: their sum is kept at hand. */
void VoxelClusters::addRow(int columns) {
  int current = -1;
  Voxel sum, *target = nullptr;
  for (std::size_t u = 0; u < static_cast<std::size_t>(columns); ++u) {
    if (key_[u] != current) {
      if (target) *target = sum;
      current = key_[u];
      target = current < 0 ? nullptr : voxelAt(current);
      if (target) sum = *target;
    }
    if (!target) continue;
    sum.x += x_[u];
    sum.y += y_[u];
    sum.z += z_[u];
    ++sum.count;
  }
  if (target) *target = sum;
}

VoxelClusters::Voxel* VoxelClusters::voxelAt(int key) {
  const int column = key >> kLayerBits, layer = key & ((1 << kLayerBits) - 1);
  int& block = blockOf_[static_cast<std::size_t>(column) +
                        static_cast<std::size_t>(reach_ * side_ + reach_)];
  if (block < 0) {
    block = static_cast<int>(columns_.size());
    columns_.push_back(column + reach_ * side_ + reach_);
    voxels_.resize(voxels_.size() + static_cast<std::size_t>(layers_));
  }
  return &voxels_[static_cast<std::size_t>(block * layers_ + layer)];
}

/** Centroids of the voxels with enough points, between the heights (steps 2a and 2b). */
void VoxelClusters::keepVoxels() {
  const auto lowest = static_cast<float>(parameters_.zMin_m),
             highest = static_cast<float>(parameters_.zMax_m);
  occupied_.assign(columns_.size(), 0);
  for (std::size_t block = 0; block < columns_.size(); ++block)
    for (int layer = 0; layer < layers_; ++layer) {
      Voxel& voxel =
          voxels_[block * static_cast<std::size_t>(layers_) + static_cast<std::size_t>(layer)];
      if (voxel.count < parameters_.fewestPoints) continue;
      const auto points = static_cast<float>(voxel.count);
      voxel = {voxel.x / points, voxel.y / points, voxel.z / points,
               static_cast<int>(cloud_.points.size())};
      if (voxel.z < lowest || voxel.z > highest) continue;
      occupied_[block] |= std::uint64_t{1} << layer;
      cloud_.points.emplace_back(voxel.x, voxel.y, voxel.z);
    }
}

/** Joins voxels that are near enough (step 2c): first to parts of columns, then part with part,
 * adjacent columns first, since after that most parts farther away are of one cluster already. */
void VoxelClusters::connect() {
  parent_.resize(cloud_.points.size());
  parts_.clear();
  firstPart_.clear();
  for (std::size_t block = 0; block < columns_.size(); ++block) addParts(block);
  firstPart_.push_back(parts_.size());
  joinNeighbours(true);
  for (Part& part : parts_) part.point = rootOf(part.point);
  joinNeighbours(false);
}

/** Parts a column, from its top down: mostly, the next voxel is near the one above. */
void VoxelClusters::addParts(std::size_t block) {
  const std::size_t first = parts_.size();
  firstPart_.push_back(first);
  std::uint64_t bit = 0;
  for (std::uint64_t left = occupied_[block]; left != 0; left ^= bit) {
    bit = std::uint64_t{1} << (63 - __builtin_clzll(left));
    Part part{block, bit, 0};
    for (std::size_t i = first; i < parts_.size();) {
      if (isNear(part, parts_[i], bit)) {
        part.voxels |= parts_[i].voxels;
        parts_[i] = parts_.back();
        parts_.pop_back();
      } else {
        ++i;
      }
    }
    parts_.push_back(part);
  }
  for (std::size_t i = first; i < parts_.size(); ++i) {
    parts_[i].point = voxelsOf(block)[__builtin_ctzll(parts_[i].voxels)].count;
    for (std::uint64_t left = parts_[i].voxels; left != 0; left &= left - 1)
      parent_[static_cast<std::size_t>(voxelsOf(block)[__builtin_ctzll(left)].count)] =
          parts_[i].point;
  }
}

void VoxelClusters::joinNeighbours(bool adjacent) {
  for (std::size_t block = 0; block < columns_.size(); ++block) {
    if (occupied_[block] == 0) continue;
    for (const Offset& offset : neighbours_) {
      if (offset.adjacent != adjacent) continue;
      const int other = blockOf_[static_cast<std::size_t>(columns_[block] + offset.column)];
      if (other >= 0) join(block, static_cast<std::size_t>(other));
    }
  }
}

void VoxelClusters::join(std::size_t block, std::size_t other) {
  for (std::size_t i = firstPart_[block]; i < firstPart_[block + 1]; ++i)
    for (std::size_t j = firstPart_[other]; j < firstPart_[other + 1]; ++j) {
      if (parts_[i].point == parts_[j].point) continue;  // spares most the look at their roots
      const int a = rootOf(parts_[i].point), b = rootOf(parts_[j].point);
      if (a != b && isNear(parts_[i], parts_[j], parts_[i].voxels))
        parent_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
}

/** Whether one of these voxels of the one part is near enough to one of the other. */
bool VoxelClusters::isNear(const Part& part, const Part& other, std::uint64_t voxels) const {
  const float reachSquared = static_cast<float>(parameters_.tolerance_m * parameters_.tolerance_m);
  for (std::uint64_t left = voxels; left != 0; left &= left - 1) {
    const int layer = __builtin_ctzll(left);
    const Voxel& a = voxelsOf(part.block)[layer];
    for (std::uint64_t near = other.voxels & window(layer, reach_); near != 0; near &= near - 1) {
      const Voxel& b = voxelsOf(other.block)[__builtin_ctzll(near)];
      const float dx = a.x - b.x, dy = a.y - b.y, dz = a.z - b.z;
      if (dx * dx + dy * dy + dz * dz <= reachSquared) return true;
    }
  }
  return false;
}

int VoxelClusters::rootOf(int point) {
  auto i = static_cast<std::size_t>(point);
  while (parent_[i] != static_cast<int>(i)) {
    parent_[i] = parent_[static_cast<std::size_t>(parent_[i])];
    i = static_cast<std::size_t>(parent_[i]);
  }
  return static_cast<int>(i);
}

/** Numbers the clusters that are large enough, in the order of their first points. */
void VoxelClusters::number() {
  const std::size_t count = cloud_.points.size();
  size_.assign(count, 0);
  for (std::size_t i = 0; i < count; ++i)
    ++size_[static_cast<std::size_t>(rootOf(static_cast<int>(i)))];
  cloud_.cluster.resize(count);
  cloud_.clusters = 0;
  for (std::size_t i = 0; i < count; ++i) {  // a root comes before all others of its cluster
    const auto root = static_cast<std::size_t>(rootOf(static_cast<int>(i)));
    if (root != i)
      cloud_.cluster[i] = cloud_.cluster[root];
    else
      cloud_.cluster[i] = size_[root] >= parameters_.fewestVoxels ? cloud_.clusters++ : -1;
  }
}

}  // namespace bslnav
