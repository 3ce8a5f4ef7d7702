#include <bslnav/config/Config.h>
#include <bslnav/config/Error.h>

#include <filesystem>

namespace bslnav {

std::string dataDirectory() {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  for (const fs::path& candidate :
       {program.parent_path().parent_path() / "share" / "bslnav", fs::path(BSLNAV_SOURCE_DATA_DIR)})
    if (fs::is_directory(candidate / "config" / "methods", ignored)) return candidate.string();
  throw Error(program.string(),
              "its data directory (share/bslnav beside it) is missing; install bslnav again");
}

std::string dataFile(const std::string& file) {
  if (std::filesystem::exists(file)) return file;
  const std::string shipped = dataDirectory() + "/" + file;
  return std::filesystem::exists(shipped) ? shipped : file;
}

}  // namespace bslnav
