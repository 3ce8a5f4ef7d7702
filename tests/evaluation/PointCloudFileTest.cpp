#include <bslnav/config/Error.h>
#include <bslnav/evaluation/PointCloudFile.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace bslnav {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

const PointCloud kPoints{{1.0f, -2.0f, 0.5f}, {3.25f, 0.0f, 1.0f}};

std::string saved(CloudFormat format, const std::vector<int>& labels = {}) {
  const auto stem = testing::TempDir() + "bslnav_cloud_test";
  const std::string path = saveCloud(stem, format, kPoints, labels);
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  std::filesystem::remove(path);
  return text.str();
}

TEST(PointCloudFile, IsAPcdWithItsNumberOfPoints) {
  const std::string text = saved(CloudFormat::Pcd);
  EXPECT_THAT(text, HasSubstr("FIELDS x y z\n"));
  EXPECT_THAT(text, HasSubstr("POINTS 2\nDATA ascii\n"));
  EXPECT_THAT(text, EndsWith("1.0000 -2.0000 0.5000\n3.2500 0.0000 1.0000\n"));
}

TEST(PointCloudFile, IsAPlyWithTheClusterOfEachPoint) {
  const std::string text = saved(CloudFormat::Ply, {4, -1});
  EXPECT_THAT(text, HasSubstr("element vertex 2\n"));
  EXPECT_THAT(text, HasSubstr("property int label\nend_header\n"));
  EXPECT_THAT(text, EndsWith("1.0000 -2.0000 0.5000 4\n3.2500 0.0000 1.0000 -1\n"));
}

TEST(PointCloudFile, SaysWhereItCannotBeWritten) {
  EXPECT_THROW(saveCloud("/no/such/directory/cloud", CloudFormat::Ply, kPoints), Error);
}

}  // namespace
}  // namespace bslnav
