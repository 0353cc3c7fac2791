// Everything that computes the force of a case, ready to be timed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/fuzzy/kernels.h"

#include "tests/bench/cases.h"
#include "tests/bench/interleaved.h"

namespace tactus::bench {

/// A way to compute the forces of a case. The case must outlive it.
struct Contender {
  std::string family;  ///< contenders of one family differ in `setting` only
  int setting = 0;     ///< samples, resolution or size; 0 where there is none
  const Case* about = nullptr;
  Job job;
};

/// CompiledModel::evaluate, a point at a time.
Contender onePoint(const Case& about);
/// The same with the kernels of one instruction set. They must outlive it, as all kernels do.
Contender onePoint(const Case& about, const fuzzy::Kernels& kernels);
/// evaluateBatch over arrays.
Contender batch(const Case& about);
/// Scene::evaluate and Scene::evaluateBatch, specialized to the fixed inputs of the case.
Contender sceneOnePoint(const Case& about);
Contender sceneBatch(const Case& about);

/// The C source, compiled with `cc -O2`: a point at a time, and a batch. Of the scene where the case fixes inputs. None
/// where there is no C compiler.
std::vector<Contender> cSource(const Case& about);

/// Our firing strengths, then the centroid from `samples` midpoints of equal cells, as well as it can be done: the
/// terms are tabulated at the samples beforehand, and the loops over the samples are vectorised. One expert.
Contender sampledCentroid(const Case& about, int samples);

/// A table of `size` x `size` exact forces over the two inputs that are not fixed, bilinear in between.
Contender lookUpTable(const Case& about, int size);

/// fuzzylite at `resolution` (samples of its centroid), or nothing where it is not installed. One expert.
std::optional<Contender> fuzzylite(const Case& about, int resolution);

}  // namespace tactus::bench
