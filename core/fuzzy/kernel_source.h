// The source of the kernels. Included by kernels.cpp once per instruction set, each time inside another namespace and
// under another target; not for anybody else. The compiler splits what the machine cannot do at once.
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
