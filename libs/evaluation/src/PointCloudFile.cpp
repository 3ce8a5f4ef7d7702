#include <bslnav/evaluation/PointCloudFile.h>
#include <bslnav/evaluation/RunRecorder.h>

#include <cstdio>

namespace bslnav {
namespace {

std::string pcdHeader(std::size_t count, bool labelled) {
  const std::string n = std::to_string(count);
  return std::string("# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n") +
         (labelled ? "FIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F I\nCOUNT 1 1 1 1\n"
                   : "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n") +
         "WIDTH " + n + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + n + "\nDATA ascii\n";
}

std::string plyHeader(std::size_t count, bool labelled) {
  return "ply\nformat ascii 1.0\ncomment robot frame, metres\nelement vertex " +
         std::to_string(count) + "\nproperty float x\nproperty float y\nproperty float z\n" +
         (labelled ? "property int label\n" : "") + "end_header\n";
}

}  // namespace

std::string saveCloud(const std::string& stem, CloudFormat format, const PointCloud& points,
                      const std::vector<int>& labels) {
  const bool pcd = format == CloudFormat::Pcd, labelled = !labels.empty();
  std::string text = pcd ? pcdHeader(points.size(), labelled) : plyHeader(points.size(), labelled);
  char row[96];
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& p = points[i];
    std::snprintf(row, sizeof row, "%.4f %.4f %.4f", static_cast<double>(p.x),
                  static_cast<double>(p.y), static_cast<double>(p.z));
    text += row;
    text += labelled ? " " + std::to_string(labels[i]) + "\n" : "\n";
  }
  std::string path = stem + (pcd ? ".pcd" : ".ply");
  writeFile(path, text);
  return path;
}

}  // namespace bslnav
