#pragma once

/// Attribute to put before a function that loops over arrays: also compiles it for AVX2, selected
/// at run time if the processor has it. The results are equal. Off under sanitizers, whose runtime
/// starts after the selection.
#if defined(__x86_64__) && !defined(FORGE_SANITIZED)
#define FORGE_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define FORGE_WIDE_VECTORS
#endif
