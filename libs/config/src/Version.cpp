#include <bslnav/config/Version.h>

namespace bslnav {

const char* version() { return BSLNAV_VERSION; }

}  // namespace bslnav
