// The source of the kernels. Only kernels.cpp includes it: once per instruction set, each time in another namespace and
// for another target. If the processor lacks an operation of the full width, the compiler splits it.
#include "core/fuzzy/kernel_vectors.h"
//
#include "core/fuzzy/kernel_centroid.h"
//
#include "core/fuzzy/kernel_batch.h"
#if TACTUS_KERNEL_WIDTH <= 4
#include "core/fuzzy/kernel_fuzzify.h"
//
#include "core/fuzzy/kernel_point.h"
#endif

#undef TACTUS_EACH_PART
#undef TACTUS_INLINE
#undef TACTUS_KERNEL_WIDTH
