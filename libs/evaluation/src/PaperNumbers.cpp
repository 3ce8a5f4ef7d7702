#include <bslnav/evaluation/PaperNumbers.h>

namespace bslnav {

std::optional<PaperNumbers> paperNumbers(const std::string& caseName, int method) {
  struct Entry {
    const char* caseName;
    int method;
    PaperNumbers numbers;
  };
  static const Entry kEntries[] = {
      {"s1", 1, {Outcome::Contact, std::nullopt}},
      {"s1", 2, {Outcome::Goal, 25.3}},
      {"s1", 3, {Outcome::Goal, 20.2}},
      {"s1", 4, {Outcome::Goal, 18.3}},
      {"s2", 1, {Outcome::Contact, std::nullopt}},
      {"s2", 2, {Outcome::Goal, 23.8}},
      {"s2", 3, {Outcome::Goal, 21.2}},
      {"s2", 4, {Outcome::Goal, 20.5}},
      {"e1", 4, {Outcome::Goal, std::nullopt}},
      {"e2", 4, {Outcome::Goal, std::nullopt}},
  };
  for (const Entry& entry : kEntries)
    if (caseName == entry.caseName && method == entry.method) return entry.numbers;
  return std::nullopt;
}

}  // namespace bslnav
