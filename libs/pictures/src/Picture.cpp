#include <bslnav/config/Error.h>
#include <bslnav/pictures/Picture.h>

#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace bslnav {

void Picture::save(const std::string& path) const {
  if (width <= 0 || height <= 0) throw Error(path, "an empty picture", Error::Kind::Run);
  const cv::Mat image(height, width, CV_8UC3, const_cast<std::uint8_t*>(rgb.data()));
  cv::Mat bgr;
  cv::cvtColor(image, bgr, cv::COLOR_RGB2BGR);
  std::vector<unsigned char> png;
  cv::imencode(".png", bgr, png, {cv::IMWRITE_PNG_COMPRESSION, 7});
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
  file.close();
  if (!file) throw Error(path, "cannot write the picture", Error::Kind::Run);
}

}  // namespace bslnav
