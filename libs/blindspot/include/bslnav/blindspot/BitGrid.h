#pragma once

#include <bslnav/costmap/CostGrid.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace bslnav {

/** A set of cells, one bit each, for filters over a whole grid in every control cycle; nothing
 * after construction allocates. What is outside the grid is in no set, and in no complement. */
class BitGrid {
 public:
  BitGrid(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  bool at(int x, int y) const { return ((row(y)[x / 64] >> (x % 64)) & 1u) != 0; }
  void clear() { std::fill(bits_.begin(), bits_.end(), 0); }
  void set(int x, int y) { row(y)[x / 64] |= std::uint64_t{1} << (x % 64); }

  /** The cells of a grid of this size that are not 0. */
  void assign(const CostGrid& grid);
  /** Sets the cells of a grid of this size to 255 in the set, to 0 elsewhere. */
  void copyTo(CostGrid& grid) const;

  void add(const BitGrid& other);     ///< union
  void remove(const BitGrid& other);  ///< difference
  void keep(const BitGrid& other);    ///< intersection
  void invert();
  void addBorder();  ///< the outermost cells

  /** Adds the four neighbours of every cell, or all eight. */
  void growCross();
  void growSquare();
  /** Adds the disc of cells with dx² + dy² ≤ radius² around every cell. */
  void growDisc(int radius);
  /** Leaves the cells over which such a disc can be placed within the set; the outside hinders
   * nobody. */
  void openDisc(int radius);
  /** Adds what is connected with the set by four neighbours through the cells of `through`; what is
   * not in `through` is dropped. */
  void flood(const BitGrid& through);

  /** Calls visit(x, y) for each cell of the set, row by row. */
  template <typename Visit>
  void forEach(Visit&& visit) const {
    for (int y = 0; y < height_; ++y)
      for (int word = 0; word < words_; ++word)
        for (std::uint64_t rest = row(y)[word]; rest != 0; rest &= rest - 1)
          visit(64 * word + __builtin_ctzll(rest), y);
  }

 private:
  std::uint64_t* row(int y) { return bits_.data() + std::ptrdiff_t{y} * words_; }
  const std::uint64_t* row(int y) const { return bits_.data() + std::ptrdiff_t{y} * words_; }
  bool floodRow(int y, int from, const BitGrid& through);
  void spread(std::uint64_t* cells, const std::uint64_t* through) const;
  void clearTail();

  int width_, height_, words_;  // words of a row; unused bits at its end are 0
  std::vector<std::uint64_t> bits_, spare_;
  std::vector<std::uint64_t> rowA_, rowB_;  // work space
};

}  // namespace bslnav
