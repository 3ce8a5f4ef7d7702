#pragma once

namespace bslnav {

/** The processes of a program that mpirun started; a program started without it is alone. */
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  long rank() const { return rank_; }
  long size() const { return size_; }
  /** Returns when all have called it. */
  void wait() const;
  /** After this process failed: says why and ends all of them, which would wait for ever. Returns
   * when it is alone. */
  void fail(const char* why) const;

 private:
  bool started_ = false;
  int rank_ = 0, size_ = 1;
};

}  // namespace bslnav
