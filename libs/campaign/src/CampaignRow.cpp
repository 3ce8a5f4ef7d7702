#include <bslnav/campaign/CampaignRow.h>
#include <bslnav/config/Error.h>

#include <array>
#include <charconv>
#include <cstdio>

namespace bslnav {
namespace {

constexpr std::array kColumns = {
    "encounter",       "family",         "seed",         "method",      "engine",
    "sensors",         "outcome",        "contact",      "at_fault",    "impact_speed_mps",
    "min_clearance_m", "time_to_goal_s", "time_empty_s", "yardstick_s", "path_length_m",
    "time_stopped_s",  "lapse_s"};

std::string text(double value) {
  char digits[48];
  std::snprintf(digits, sizeof digits, "%.4f", value);
  return digits;
}

std::string text(const std::optional<double>& value) { return value ? text(*value) : ""; }

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields(1);
  for (const char c : line)
    if (c == ',')
      fields.emplace_back();
    else
      fields.back() += c;
  return fields;
}

/** The fields of a row, in order. */
class Reader {
 public:
  Reader(const std::string& line, std::string where)
      : fields_(split(line)), where_(std::move(where)) {
    if (fields_.size() != kColumns.size())
      throw Error(where_, "expected " + std::to_string(kColumns.size()) + " columns",
                  Error::Kind::Run);
  }

  std::string word() { return fields_[next_++]; }

  template <typename Number>
  Number number() {
    const std::string& field = fields_[next_];
    Number value{};
    const char* end = field.data() + field.size();
    const auto result = std::from_chars(field.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end)
      throw Error(where_ + " " + kColumns[next_], "'" + field + "' is not a number; expected one",
                  Error::Kind::Run);
    ++next_;
    return value;
  }

  std::optional<double> maybe() {
    if (!fields_[next_].empty()) return number<double>();
    ++next_;
    return std::nullopt;
  }

 private:
  std::vector<std::string> fields_;
  std::string where_;
  std::size_t next_ = 0;
};

}  // namespace

void CampaignRow::take(const RunSummary& run) {
  outcome = nameOf(run.outcome);
  contact = run.contact;
  atFault = run.atFault;
  impactSpeed_mps = run.impactSpeed_mps;
  minClearance_m = run.minClearance_m;
  timeToGoal_s = run.timeToGoal_s;
  pathLength_m = run.pathLength_m;
  timeStopped_s = run.timeStopped_s;
  lapse_s = run.lapse_s;
}

std::string CampaignRow::csvHeader() {
  std::string header;
  for (const char* column : kColumns) header += (header.empty() ? "" : ",") + std::string(column);
  return header;
}

std::string CampaignRow::csv() const {
  const std::vector<std::string> fields = {std::to_string(encounter),
                                           family,
                                           std::to_string(seed),
                                           std::to_string(method),
                                           engine,
                                           sensors,
                                           outcome,
                                           std::to_string(int{contact}),
                                           std::to_string(int{atFault}),
                                           text(impactSpeed_mps),
                                           text(minClearance_m),
                                           text(timeToGoal_s),
                                           text(timeEmpty_s),
                                           text(yardstick_s),
                                           text(pathLength_m),
                                           text(timeStopped_s),
                                           text(lapse_s)};
  std::string line;
  for (const std::string& field : fields) line += (&field == &fields.front() ? "" : ",") + field;
  return line;
}

CampaignRow CampaignRow::fromCsv(const std::string& line, const std::string& where) {
  Reader reader(line, where);
  CampaignRow row;
  row.encounter = reader.number<long>();
  row.family = reader.word();
  row.seed = reader.number<std::uint64_t>();
  row.method = reader.number<int>();
  row.engine = reader.word();
  row.sensors = reader.word();
  row.outcome = reader.word();
  row.contact = reader.number<int>() != 0;
  row.atFault = reader.number<int>() != 0;
  row.impactSpeed_mps = reader.maybe();
  row.minClearance_m = reader.maybe();
  row.timeToGoal_s = reader.maybe();
  row.timeEmpty_s = reader.maybe();
  row.yardstick_s = reader.maybe();
  row.pathLength_m = reader.number<double>();
  row.timeStopped_s = reader.number<double>();
  row.lapse_s = reader.number<double>();
  return row;
}

}  // namespace bslnav
