#include <bslnav/blindspot/BitGrid.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>

#include "../support/HeapUse.h"

namespace bslnav {
namespace {

using Cells = std::function<bool(int, int)>;

/** The grid of a rule, which is asked about cells within it only. */
CostGrid gridOf(int width, int height, const Cells& isIn) {
  CostGrid grid(width, height, 0.05, 0.0, 0.0, 0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) grid.at(x, y) = isIn(x, y) ? 255 : 0;
  return grid;
}
BitGrid bitsOf(const CostGrid& grid) {
  BitGrid bits(grid.width(), grid.height());
  bits.assign(grid);
  return bits;
}
bool areSame(const BitGrid& bits, const CostGrid& expected) {
  CostGrid actual(expected.width(), expected.height(), 0.05, 0.0, 0.0, 7);
  bits.copyTo(actual);
  for (int y = 0; y < expected.height(); ++y)
    if (!std::equal(actual.row(y), actual.row(y) + actual.width(), expected.row(y))) return false;
  return true;
}

/** Widths on both sides of whole words, from nearly empty to nearly full. */
CostGrid anyGrid(int width, int height) {
  const int fullness = *rc::gen::inRange(2, 98);
  const auto seed = *rc::gen::inRange<unsigned>(1, 1u << 30);
  unsigned state = seed;
  return gridOf(width, height, [&state, fullness](int, int) {
    state = state * 1664525u + 1013904223u;
    return static_cast<int>(state >> 16) % 100 < fullness;
  });
}
int anyWidth() { return *rc::gen::element(1, 5, 63, 64, 65, 128, 161); }

/** A cell is in if any cell of the set is within reach of it. */
CostGrid grown(const CostGrid& grid, int reach, const Cells& isReached) {
  return gridOf(grid.width(), grid.height(), [&](int x, int y) {
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx)
        if (isReached(dx, dy) && grid.bounds().contains(x + dx, y + dy) &&
            grid.at(x + dx, y + dy) != 0)
          return true;
    return false;
  });
}
CostGrid inverted(const CostGrid& grid) {
  return gridOf(grid.width(), grid.height(), [&grid](int x, int y) { return grid.at(x, y) == 0; });
}

RC_GTEST_PROP(BitGrid, GrowsAsCellByCell, ()) {
  const CostGrid grid = anyGrid(anyWidth(), *rc::gen::inRange(1, 20));
  const int radius = *rc::gen::inRange(0, 6);
  const auto disc = [radius](int dx, int dy) { return dx * dx + dy * dy <= radius * radius; };
  BitGrid cross = bitsOf(grid), square = cross, round = cross, open = cross;
  cross.growCross();
  square.growSquare();
  round.growDisc(radius);
  open.openDisc(radius);
  RC_ASSERT(areSame(cross, grown(grid, 1, [](int dx, int dy) { return dx == 0 || dy == 0; })));
  RC_ASSERT(areSame(square, grown(grid, 1, [](int, int) { return true; })));
  RC_ASSERT(areSame(round, grown(grid, radius, disc)));
  const CostGrid eroded = inverted(grown(inverted(grid), radius, disc));
  RC_ASSERT(areSame(open, grown(eroded, radius, disc)));
}

/** Flooding is growing by four neighbours within the other set until nothing changes. */
RC_GTEST_PROP(BitGrid, FloodsAsStepByStep, ()) {
  const int width = anyWidth(), height = *rc::gen::inRange(1, 20);
  const CostGrid through = anyGrid(width, height);
  BitGrid flooded(width, height), stepped(width, height), before(width, height);
  const int x = *rc::gen::inRange(0, width), y = *rc::gen::inRange(0, height);
  flooded.set(x, y);
  stepped.set(x, y);
  flooded.flood(bitsOf(through));
  stepped.keep(bitsOf(through));
  for (int step = 0; step < width * height; ++step) {
    stepped.growCross();
    stepped.keep(bitsOf(through));
  }
  CostGrid expected(width, height, 0.05, 0.0, 0.0, 0);
  stepped.copyTo(expected);
  RC_ASSERT(areSame(flooded, expected));
}

RC_GTEST_PROP(BitGrid, CombinesSets, ()) {
  const int width = anyWidth();
  const CostGrid a = anyGrid(width, 5), b = anyGrid(width, 5);
  const auto combined = [&](const std::function<bool(bool, bool)>& rule) {
    return gridOf(width, 5, [&](int x, int y) { return rule(a.at(x, y) != 0, b.at(x, y) != 0); });
  };
  BitGrid sum = bitsOf(a), rest = sum, both = sum, none = sum;
  sum.add(bitsOf(b));
  rest.remove(bitsOf(b));
  both.keep(bitsOf(b));
  none.invert();
  RC_ASSERT(areSame(sum, combined([](bool p, bool q) { return p || q; })));
  RC_ASSERT(areSame(rest, combined([](bool p, bool q) { return p && !q; })));
  RC_ASSERT(areSame(both, combined([](bool p, bool q) { return p && q; })));
  RC_ASSERT(areSame(none, inverted(a)));
}

TEST(BitGrid, VisitsItsCellsRowByRow) {
  BitGrid bits(130, 3);
  bits.set(129, 0);
  bits.set(0, 2);
  bits.set(64, 2);
  std::vector<std::pair<int, int>> cells;
  bits.forEach([&cells](int x, int y) { cells.emplace_back(x, y); });
  EXPECT_EQ(cells, (std::vector<std::pair<int, int>>{{129, 0}, {0, 2}, {64, 2}}));
}

TEST(BitGrid, AllocatesNothing) {
  BitGrid bits(161, 161), all(161, 161);
  all.invert();
  bits.addBorder();
  const long before = test::heapUse().allocations;
  bits.growSquare();
  bits.growCross();
  bits.openDisc(4);
  bits.flood(all);
  EXPECT_EQ(test::heapUse().allocations, before);
}

}  // namespace
}  // namespace bslnav
