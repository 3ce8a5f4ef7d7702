#pragma once

#include <memory>

#include "PseudoTerminal.h"
#include "TcpServerLine.h"
#include "TextBaseEmulator.h"

namespace bslnav::test {

/** What the emulated base is connected by. */
struct TextBaseEmulator::Line {
  virtual ~Line() = default;
  virtual std::string address() const = 0;
  virtual std::string read(double timeout_s) = 0;
  virtual void write(const std::string& bytes) = 0;
  virtual void hangUp() = 0;
};

std::unique_ptr<TextBaseEmulator::Line> makeSerialLine();
std::unique_ptr<TextBaseEmulator::Line> makeTcpLine();

}  // namespace bslnav::test
