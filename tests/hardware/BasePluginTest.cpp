#include <bslnav/config/Error.h>
#include <bslnav/hardware/BasePlugin.h>
#include <gmock/gmock.h>

namespace bslnav {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Options = std::map<std::string, std::string>;

std::string errorOf(const std::string& library, const Options& options = {},
                    Error::Kind kind = Error::Kind::Configuration) {
  try {
    loadBase(library, options);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind);
    return error.what();
  }
  return {};
}

TEST(BasePlugin, GivesABaseWithItsOptions) {
  const auto base = loadBase(BSLNAV_TEST_BASE, {{"halt", "bumper"}});
  EXPECT_EQ(base->state().halt, "bumper");
  base->drive({0.5, 0.0, 0.25});
  EXPECT_EQ(base->state().twist.omega, 0.25);
  base->stop();
  EXPECT_EQ(base->state().twist.vx, 0.0);
}

TEST(BasePlugin, GivesAsManyBasesAsAreWanted) {
  const auto one = loadBase(BSLNAV_TEST_BASE, {{"halt", "one"}});
  { const auto other = loadBase(BSLNAV_TEST_BASE, {{"halt", "other"}}); }
  EXPECT_EQ(one->state().halt, "one");
}

// Thrown by code of the library, and still there when the base is not.
TEST(BasePlugin, ItsExceptionsOutliveIt) {
  try {
    const auto base = loadBase(BSLNAV_TEST_BASE, {});
    base->drive({-1.0, 0.0, 0.0});
    base->state();
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "test base: is gone");
  }
}

TEST(BasePlugin, NamesALibraryThatIsMissing) {
  EXPECT_THAT(errorOf("/no/such/library.so"),
              AllOf(HasSubstr("/no/such/library.so: cannot be loaded"),
                    HasSubstr("expected a shared library made with BSLNAV_BASE_PLUGIN")));
}

TEST(BasePlugin, NamesALibraryThatIsNoPlugin) {
  EXPECT_THAT(errorOf("libm.so.6"),
              AllOf(HasSubstr("libm.so.6: has no bslnavBasePluginVersion"),
                    HasSubstr("expected a shared library made with BSLNAV_BASE_PLUGIN")));
}

TEST(BasePlugin, NamesAnotherVersion) {
  EXPECT_THAT(errorOf(BSLNAV_OTHER_VERSION),
              AllOf(HasSubstr(BSLNAV_OTHER_VERSION), HasSubstr("was made for 'bslnav base 0'"),
                    HasSubstr("expected one made for '" BSLNAV_BASE_PLUGIN_VERSION "'")));
}

TEST(BasePlugin, TellsWhyTheBaseCannotBeMade) {
  const std::string prefix = BSLNAV_TEST_BASE ": its base cannot be made";
  EXPECT_EQ(errorOf(BSLNAV_TEST_BASE, {{"error", "expected another"}}),
            prefix + ": option error: expected another");
  EXPECT_EQ(errorOf(BSLNAV_TEST_BASE, {{"exception", "no such port"}}, Error::Kind::Run),
            prefix + ": no such port");
  EXPECT_THAT(errorOf(BSLNAV_TEST_BASE, {{"number", ""}}, Error::Kind::Run), HasSubstr(prefix));
}

}  // namespace
}  // namespace bslnav
