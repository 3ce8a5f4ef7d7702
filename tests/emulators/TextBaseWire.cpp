#include "TextBaseWire.h"

namespace bslnav::test {
namespace {

struct SerialLine : TextBaseEmulator::Line {
  std::string address() const override { return terminal.path(); }
  std::string read(double timeout_s) override { return terminal.read(timeout_s); }
  void write(const std::string& bytes) override { terminal.write(bytes); }
  void hangUp() override { terminal.hangUp(); }

  PseudoTerminal terminal;
};

struct TcpLine : TextBaseEmulator::Line {
  std::string address() const override { return server.address(); }
  std::string read(double timeout_s) override { return server.read(timeout_s); }
  void write(const std::string& bytes) override { server.write(bytes); }
  void hangUp() override { server.hangUp(); }

  TcpServerLine server;
};

}  // namespace

std::unique_ptr<TextBaseEmulator::Line> makeSerialLine() { return std::make_unique<SerialLine>(); }

std::unique_ptr<TextBaseEmulator::Line> makeTcpLine() { return std::make_unique<TcpLine>(); }

}  // namespace bslnav::test
