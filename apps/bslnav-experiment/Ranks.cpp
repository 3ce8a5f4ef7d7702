#include "Ranks.h"

#include <mpi.h>

#include <cstdio>
#include <cstdlib>

namespace bslnav {
namespace {

/** Whether mpirun started this process: what Open MPI, and what MPICH and its kin leave there. */
bool underMpirun() {
  return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr || std::getenv("PMI_SIZE") != nullptr;
}

}  // namespace

Ranks::Ranks() {
  if (!underMpirun()) return;
  MPI_Init(nullptr, nullptr);
  started_ = true;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Ranks::~Ranks() {
  if (started_) MPI_Finalize();
}

void Ranks::wait() const {
  if (started_) MPI_Barrier(MPI_COMM_WORLD);
}

void Ranks::fail(const char* why) const {
  if (!started_) return;
  std::fprintf(stderr, "process %d of %d: %s\n", rank_, size_, why);
  MPI_Abort(MPI_COMM_WORLD, 1);
}

}  // namespace bslnav
