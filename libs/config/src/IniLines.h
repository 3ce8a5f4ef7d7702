#pragma once

#include <string>

namespace bslnav {

/** Refuses what MRPT's INI reader would drop in silence: lines that are neither a section, a key, a
 * `@define` nor a comment, keys before any section, keys given twice in one section.
 *  @throws Error naming file and line */
void checkIniLines(const std::string& file);

}  // namespace bslnav
