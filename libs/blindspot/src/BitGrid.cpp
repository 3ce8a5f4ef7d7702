#include <bslnav/blindspot/BitGrid.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace bslnav {
namespace {

/** A word of a row whose bits are spread to their neighbours before and after. */
std::uint64_t widened(const std::uint64_t* row, int word, int words) {
  const std::uint64_t before = word > 0 ? row[word - 1] >> 63 : 0;
  const std::uint64_t after = word + 1 < words ? row[word + 1] << 63 : 0;
  return row[word] | row[word] << 1 | before | row[word] >> 1 | after;
}

/** A bit each for eight cells, the lowest for the first: whether it is not 0. */
std::uint8_t nonZeroOf(const Cost* cells) {
  constexpr std::uint64_t kLow7 = 0x7f7f7f7f7f7f7f7f, kTops = 0x8080808080808080;
  std::uint64_t eight;
  std::memcpy(&eight, cells, sizeof(eight));  // little-endian, as Debian's machines with MRPT are
  const std::uint64_t tops = (((eight & kLow7) + kLow7) | eight) & kTops;
  return static_cast<std::uint8_t>(((tops >> 7) * 0x0102040810204080) >> 56);
}

/** The other way: 255 in each of eight bytes whose bit is set. */
std::uint64_t bytesOf(std::uint64_t bits) {
  constexpr std::uint64_t kEach = 0x0101010101010101, kOwn = 0x8040201008040201;
  const std::uint64_t own = ((bits & 0xff) * kEach) & kOwn;  // each byte keeps its own bit
  const std::uint64_t tops = (own + 0x7f7f7f7f7f7f7f7f) | own;
  return ((tops >> 7) & kEach) * 255;
}

std::uint64_t reversed(std::uint64_t bits) {
  bits = ((bits >> 1) & 0x5555555555555555) | ((bits & 0x5555555555555555) << 1);
  bits = ((bits >> 2) & 0x3333333333333333) | ((bits & 0x3333333333333333) << 2);
  bits = ((bits >> 4) & 0x0f0f0f0f0f0f0f0f) | ((bits & 0x0f0f0f0f0f0f0f0f) << 4);
  return __builtin_bswap64(bits);
}

/** The bits of `through` from each of `seeds`, which are among them, up to the end of its run:
 * where adding a seed carries to. Takes over the carry of the word before and leaves its own. */
std::uint64_t filledUp(std::uint64_t seeds, std::uint64_t through, std::uint64_t& carry) {
  const std::uint64_t half = through + seeds, sum = half + carry;
  carry = half < through || sum < half ? 1 : 0;
  return ((sum ^ through) | seeds) & through;
}

}  // namespace

BitGrid::BitGrid(int width, int height)
    : width_(width), height_(height), words_((width + 63) / 64) {
  bits_.assign(static_cast<std::size_t>(words_) * static_cast<std::size_t>(height), 0);
  spare_ = bits_;
  rowA_.assign(static_cast<std::size_t>(words_), 0);
  rowB_ = rowA_;
}

void BitGrid::assign(const CostGrid& grid) {
  for (int y = 0; y < height_; ++y) {
    const Cost* cells = grid.row(y);
    for (int word = 0; word < words_; ++word) {
      const int count = std::min(64, width_ - 64 * word);
      std::uint64_t bits = 0;
      int k = 0;
      for (; k + 8 <= count; k += 8) bits |= std::uint64_t{nonZeroOf(cells + 64 * word + k)} << k;
      for (; k < count; ++k) bits |= std::uint64_t{cells[64 * word + k] != 0} << k;
      row(y)[word] = bits;
    }
  }
}

void BitGrid::copyTo(CostGrid& grid) const {
  for (int y = 0; y < height_; ++y) {
    Cost* cells = grid.row(y);
    int x = 0;
    for (; x + 8 <= width_; x += 8) {
      const std::uint64_t eight = bytesOf(row(y)[x / 64] >> (x % 64));
      std::memcpy(cells + x, &eight, sizeof(eight));
    }
    for (; x < width_; ++x) cells[x] = at(x, y) ? 255 : 0;
  }
}

void BitGrid::add(const BitGrid& other) {
  for (std::size_t i = 0; i < bits_.size(); ++i) bits_[i] |= other.bits_[i];
}
void BitGrid::remove(const BitGrid& other) {
  for (std::size_t i = 0; i < bits_.size(); ++i) bits_[i] &= ~other.bits_[i];
}
void BitGrid::keep(const BitGrid& other) {
  for (std::size_t i = 0; i < bits_.size(); ++i) bits_[i] &= other.bits_[i];
}

void BitGrid::invert() {
  for (std::uint64_t& bits : bits_) bits = ~bits;
  clearTail();
}

void BitGrid::clearTail() {
  if (width_ % 64 == 0) return;
  const std::uint64_t used = (std::uint64_t{1} << (width_ % 64)) - 1;
  for (int y = 0; y < height_; ++y) row(y)[words_ - 1] &= used;
}

void BitGrid::addBorder() {
  for (int x = 0; x < width_; ++x) set(x, 0), set(x, height_ - 1);
  for (int y = 0; y < height_; ++y) set(0, y), set(width_ - 1, y);
}

void BitGrid::growCross() {
  spare_ = bits_;
  const auto old = [this](int y, int word) {
    return spare_[static_cast<std::size_t>(y * words_ + word)];
  };
  for (int y = 0; y < height_; ++y)
    for (int word = 0; word < words_; ++word) {
      const std::uint64_t* same = spare_.data() + std::ptrdiff_t{y} * words_;
      std::uint64_t bits = widened(same, word, words_);
      if (y > 0) bits |= old(y - 1, word);
      if (y + 1 < height_) bits |= old(y + 1, word);
      row(y)[word] = bits;
    }
  clearTail();
}

void BitGrid::growSquare() {
  for (int y = 0; y < height_; ++y) {
    std::uint64_t* wide = spare_.data() + std::ptrdiff_t{y} * words_;
    for (int word = 0; word < words_; ++word) wide[word] = widened(row(y), word, words_);
  }
  for (int y = 0; y < height_; ++y)
    for (int word = 0; word < words_; ++word) {
      const std::uint64_t* wide = spare_.data() + std::ptrdiff_t{y} * words_ + word;
      std::uint64_t bits = *wide;
      if (y > 0) bits |= wide[-words_];
      if (y + 1 < height_) bits |= wide[words_];
      row(y)[word] = bits;
    }
  clearTail();
}

/** Each row is widened step by step and added to the rows where the disc is that wide. */
void BitGrid::growDisc(int radius) {
  spare_ = bits_;
  for (int y = 0; y < height_; ++y) {
    const std::uint64_t* centre = spare_.data() + std::ptrdiff_t{y} * words_;
    if (std::all_of(centre, centre + words_, [](std::uint64_t bits) { return bits == 0; }))
      continue;
    std::copy(centre, centre + words_, rowA_.begin());
    int dy = radius;
    for (int half = 0; half <= radius; ++half) {
      if (half > 0) {
        for (int word = 0; word < words_; ++word)
          rowB_[static_cast<std::size_t>(word)] = widened(rowA_.data(), word, words_);
        rowA_.swap(rowB_);
      }
      for (; dy >= 0 && (half + 1) * (half + 1) + dy * dy > radius * radius; --dy)
        for (const int to : {y - dy, y + dy})
          if (to >= 0 && to < height_)
            for (int word = 0; word < words_; ++word)
              row(to)[word] |= rowA_[static_cast<std::size_t>(word)];
    }
  }
  clearTail();
}

void BitGrid::openDisc(int radius) {
  invert();
  growDisc(radius);
  invert();
  growDisc(radius);
}

void BitGrid::flood(const BitGrid& through) {
  keep(through);
  for (int y = 0; y < height_; ++y) spread(row(y), through.row(y));
  for (bool changed = true; changed;) {
    changed = false;
    for (int y = 1; y < height_; ++y) changed = floodRow(y, y - 1, through) || changed;
    for (int y = height_ - 2; y >= 0; --y) changed = floodRow(y, y + 1, through) || changed;
  }
}

/** Takes over what a neighbouring row has reached; returns whether that is anything new. */
bool BitGrid::floodRow(int y, int from, const BitGrid& through) {
  std::uint64_t fresh = 0;
  for (int word = 0; word < words_; ++word) {
    const std::uint64_t entering = row(from)[word] & through.row(y)[word] & ~row(y)[word];
    row(y)[word] |= entering;
    fresh |= entering;
  }
  if (fresh == 0) return false;
  spread(row(y), through.row(y));
  return true;
}

/** Fills the runs of `through` in which there is a cell: up, and in the mirror down. */
void BitGrid::spread(std::uint64_t* cells, const std::uint64_t* through) const {
  std::uint64_t carry = 0;
  for (int word = 0; word < words_; ++word)
    cells[word] = filledUp(cells[word], through[word], carry);
  carry = 0;
  for (int word = words_ - 1; word >= 0; --word)
    cells[word] = reversed(filledUp(reversed(cells[word]), reversed(through[word]), carry));
}

}  // namespace bslnav
