#pragma once

#include <mrpt/io/CFileGZInputStream.h>

#include <stdexcept>

namespace bslnav {

/** A file, compressed or not, that throws where it ends early or is damaged.
 *
 * MRPT's archives take a read that gives less than it was asked for, or fails, for a success, and
 * go on with what the memory happened to hold. */
class WholeReads : public mrpt::io::CFileGZInputStream {
 public:
  size_t Read(void* buffer, size_t count) override {
    if (CFileGZInputStream::Read(buffer, count) != count)
      throw std::runtime_error("the file ends early or is damaged");
    return count;
  }
};

}  // namespace bslnav
