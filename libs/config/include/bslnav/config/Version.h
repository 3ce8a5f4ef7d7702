#pragma once

namespace bslnav {

/** The version of the project, "MAJOR.MINOR.PATCH". */
const char* version();

}  // namespace bslnav
