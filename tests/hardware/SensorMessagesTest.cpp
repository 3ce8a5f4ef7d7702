#include <bslnav/hardware/SensorMessages.h>
#include <gtest/gtest.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <array>

namespace bslnav {
namespace {

std::string bytesOf(const SensorMessage& message) {
  std::array<int, 2> ends{};
  EXPECT_EQ(::pipe(ends.data()), 0);
  EXPECT_TRUE(write(ends[1], message));
  ::close(ends[1]);
  std::string bytes(60000, '\0');
  bytes.resize(static_cast<std::size_t>(::read(ends[0], bytes.data(), bytes.size())));
  ::close(ends[0]);
  return bytes;
}

TEST(SensorMessages, AScanComesBackAsItWas) {
  mrpt::obs::CObservation2DRangeScan scan;
  scan.sensorLabel = "front";
  scan.timestamp = mrpt::Clock::fromDouble(1e9);
  scan.resizeScanAndAssign(3, 1.5f, true);
  const std::string bytes = bytesOf(messageOf(scan));
  SensorMessageReader reader;
  reader.add(bytes.data(), bytes.size());
  const auto message = reader.next();
  ASSERT_TRUE(message);
  const auto back =
      std::dynamic_pointer_cast<mrpt::obs::CObservation2DRangeScan>(observationOf(*message));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->sensorLabel, "front");
  EXPECT_EQ(back->timestamp, scan.timestamp);
  EXPECT_EQ(back->getScanRange(2), 1.5f);
  EXPECT_FALSE(reader.next());
}

RC_GTEST_PROP(SensorMessages, DoNotDependOnHowTheirBytesArrive, ()) {
  const auto words = *rc::gen::container<std::vector<std::string>>(rc::gen::string<std::string>());
  std::string bytes;
  for (const auto& text : words) bytes += bytesOf({SensorMessage::Kind::Trouble, text});
  SensorMessageReader reader;
  std::vector<std::string> got;
  for (std::size_t from = 0; from < bytes.size();) {
    const auto count = std::min(bytes.size() - from, *rc::gen::inRange<std::size_t>(1, 20));
    reader.add(bytes.data() + from, count);
    from += count;
    while (const auto message = reader.next()) got.push_back(message->bytes);
  }
  RC_ASSERT(got == words);
}

TEST(SensorMessages, NonsenseIsToldFromMessages) {
  SensorMessageReader reader;
  reader.add("a driver printed this", 21);
  EXPECT_THROW(reader.next(), std::runtime_error);
  EXPECT_THROW(observationOf({SensorMessage::Kind::Observation, "nothing"}), std::exception);
}

}  // namespace
}  // namespace bslnav
