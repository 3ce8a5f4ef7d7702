#pragma once

/** Compiles a function twice, for any x86-64 and with AVX2, and picks at start-up what the machine
 * has. Both give the same bits: AVX2 alone brings wider vectors, but no fused operations. The
 * sanitizers cannot instrument the choice. */
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define BSLNAV_VECTOR_CLONES [[gnu::target_clones("avx2", "default")]]
#else
#define BSLNAV_VECTOR_CLONES
#endif
