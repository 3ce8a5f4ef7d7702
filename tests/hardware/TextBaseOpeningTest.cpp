#include <PseudoTerminal.h>
#include <gmock/gmock.h>

#include "TextBaseRig.h"

namespace bslnav::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(TextBaseOpening, NamesABaseThatDoesNotAnswer) {
  PseudoTerminal nobody;
  std::string error;
  EXPECT_LT(secondsOf([&] { error = errorOfOpening(at(nobody.path(), 0.3)); }), 2.0);
  EXPECT_THAT(error, AllOf(HasSubstr(nobody.path()), HasSubstr("no answer within start_s")));
}

TEST(TextBaseOpening, NamesALineThatIsNone) {
  EXPECT_THAT(errorOfOpening(at("/dev/no-such-line")),
              AllOf(HasSubstr("/dev/no-such-line"), HasSubstr("serial device")));
  EXPECT_THAT(errorOfOpening(at("/dev/null")), HasSubstr("/dev/null: cannot be opened"));
  EXPECT_THAT(errorOfOpening(at("tcp:127.0.0.1:1")),
              AllOf(HasSubstr("tcp:127.0.0.1:1"), HasSubstr("cannot be connected")));
  for (const char* address :
       {"tcp:", "tcp::80", "tcp:host", "tcp:host:", "tcp:host:0", "tcp:host:70000", "tcp:host:80a"})
    EXPECT_THAT(errorOfOpening(at(address), Error::Kind::Configuration), HasSubstr("tcp:HOST:PORT"))
        << address;
}

TEST(TextBaseOpening, RefusesAnotherVersionAndALongerWatchdog) {
  TextBaseEmulator emulator;
  emulator.answerWith({2, 300});
  EXPECT_THAT(errorOfOpening(at(emulator.address())), HasSubstr("version 2"));
  emulator.answerWith({1, 1000});
  EXPECT_THAT(errorOfOpening(at(emulator.address())), HasSubstr("takes 1000 ms"));
  emulator.answerWith({1, 200});
  EXPECT_EQ(errorOfOpening(at(emulator.address())), "");
}

}  // namespace
}  // namespace bslnav::test
