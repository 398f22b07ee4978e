#pragma once

/// Before a function whose loops run over arrays: compiled for wider vectors, too, where the
/// machine may have them. The results are the same. Not under sanitizers: what chooses the function
/// runs before they are ready.
#if defined(__x86_64__) && !defined(FORGE_SANITIZED)
#define FORGE_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define FORGE_WIDE_VECTORS
#endif
