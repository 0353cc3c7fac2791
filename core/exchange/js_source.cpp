#include "core/exchange/js_source.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/exchange/c_parts.h"
#include "core/exchange/expert_view.h"

namespace tactus::exchange {
namespace {

using Layout = base::JsonWriter::Layout;

void writeTerms(base::JsonWriter& json, const std::vector<fuzzy::Term>& terms) {
  json.beginArray();
  for (const fuzzy::Term& term : terms) {
    json.beginObject(Layout::kInline).key("id").value(term.id);
    if (!term.label.empty()) json.key("label").value(term.label);
    if (term.shape == fuzzy::Shape::kGaussian) {
      json.key("gaussian").values(term.points);
    } else {
      const Corners f = cornersOf(term);
      json.key("at").values(std::vector{f.a, f.b, f.c, f.d});
    }
    json.endObject();
  }
  json.endArray();
}

void writeVariable(base::JsonWriter& json, const fuzzy::Variable& variable) {
  json.beginObject().key("id").value(variable.id);
  if (!variable.label.empty()) json.key("label").value(variable.label);
  json.key("unit").value(variable.unit).key("min").value(variable.min).key("max").value(variable.max).key("terms");
  writeTerms(json, variable.terms);
  json.endObject();
}

/// Terms of an expert's own; `null` for those of the variable.
void writeOwnTerms(base::JsonWriter& json, const fuzzy::Expert& expert, const fuzzy::Variable& variable) {
  const std::vector<fuzzy::Term>& terms = fuzzy::termsFor(expert, variable);
  if (&terms == &variable.terms) {
    json.null();
  } else {
    writeTerms(json, terms);
  }
}

void writeExpert(base::JsonWriter& json, const fuzzy::ForceModel& model, std::size_t index, double weight) {
  const fuzzy::Expert& expert = model.experts[index];
  json.beginObject().key("id").value(expert.id).key("weight").value(weight).key("inputs").beginArray();
  for (const fuzzy::Variable& input : model.inputs) writeOwnTerms(json, expert, input);
  json.endArray().key("output");
  writeOwnTerms(json, expert, model.output);
  json.key("rules").beginArray();
  for (const IndexedRule& rule : viewOf(model, index).rules) {
    if (rule.weight == 0) continue;
    json.beginArray(Layout::kInline).value(rule.then).value(rule.weight);
    for (const auto& [input, term] : rule.conditions) json.value(input).value(term);
    json.endArray();
  }
  json.endArray().endObject();
}

std::string modelText(const fuzzy::ForceModel& model, const Origin& origin) {
  base::JsonWriter json;
  json.beginObject().key("name").value(model.name);
  if (!origin.model_sha256.empty()) json.key("sha256").value(origin.model_sha256);
  json.key("implication").value(name(model.implication));
  json.key("default_force").value(model.default_force_n).key("inputs").beginArray();
  for (const fuzzy::Variable& input : model.inputs) writeVariable(json, input);
  json.endArray().key("output");
  writeVariable(json, model.output);
  json.key("experts").beginArray();
  const std::vector<double> weights = fuzzy::normalizedWeights(model);
  for (std::size_t e = 0; e < model.experts.size(); ++e) writeExpert(json, model, e, weights[e]);
  json.endArray().endObject();
  return json.text();
}

constexpr std::string_view kCentroid = R"(
/* Memberships are multiplied by this, so that the smallest keep their digits. */
const SCALE = 2 ** 512;
const LEAST = Number.MIN_VALUE;

function membership(term, x) {
  if (term.gaussian) {
    const u = (x - term.gaussian[0]) / term.gaussian[1];
    return SCALE * Math.exp(-0.5 * u * u);
  }
  const [a, b, c, d] = term.at;
  if (x < b) return x > a ? Math.max(SCALE * (x - a) / (b - a), LEAST) : 0;
  if (x <= c) return SCALE;
  return x < d ? Math.max(SCALE * (d - x) / (d - c), LEAST) : 0;
}

function outputTerms(model, expert) {
  return expert.output || model.output.terms;
}

/* The inputs within their universes; null where one is not finite. */
function clamped(model, inputs) {
  const out = model.inputs.map((input, i) => Math.min(Math.max(inputs[i], input.min), input.max));
  return model.inputs.every((input, i) => Number.isFinite(inputs[i])) ? out : null;
}

/* The strength of each output term of an expert, times SCALE; null where no rule fires. at: from clamped. */
function strengthsOf(model, expert, at) {
  const memberships = model.inputs.map(
    (input, i) => (expert.inputs[i] || input.terms).map((term) => membership(term, at[i])));
  const strengths = outputTerms(model, expert).map(() => 0);
  let fired = false;
  for (const [then, weight, ...conditions] of expert.rules) {
    let least = SCALE;
    for (let k = 0; k < conditions.length; k += 2) least = Math.min(least, memberships[conditions[k]][conditions[k + 1]]);
    if (least === 0) continue;
    strengths[then] = Math.max(strengths[then], Math.max(weight * least, LEAST));
    fired = true;
  }
  return fired ? strengths : null;
}

/* A trapezoid under its rule's strength, as heights relative to the largest. */
function setOf(corners, strength, largest, scales) {
  const [a, b, c, d] = corners;
  const top = scales ? 1 : Math.max(strength / SCALE, LEAST);
  let topLeft = a + top * (b - a), topRight = d - top * (d - c);
  if (topLeft > topRight) topLeft = topRight = (topLeft + topRight) / 2;
  return { left: a, topLeft, topRight, right: d, height: strength / largest };
}

function heightAt(set, x) {
  if (x < set.topLeft) return set.height * ((x - set.left) / (set.topLeft - set.left));
  if (x > set.topRight) return set.height * ((set.right - x) / (set.right - set.topRight));
  return set.height;
}

const ascending = (x, y) => x - y;

/* The maximum of the sets is piecewise linear; every piece is integrated exactly. From the lower end of the universe. */
function trapezoidOffset(sets, lo, hi) {
  const within = (x) => Math.min(Math.max(x, lo), hi);
  const edges = sets.flatMap((f) => [f.left, f.topLeft, f.topRight, f.right].map(within)).sort(ascending);
  let area = 0, moment = 0;
  for (let i = 1; i < edges.length; ++i) {
    const from = edges[i - 1], to = edges[i], width = to - from;
    if (!(width > 0)) continue;
    const lines = [];
    for (const f of sets) {
      if (f.left <= from && to <= f.right) lines.push([heightAt(f, from), heightAt(f, to)]);
    }
    if (lines.length === 0) continue;
    let top = lines[0];
    for (const line of lines) {
      if (line[0] > top[0] || (line[0] === top[0] && line[1] > top[1])) top = line;
    }
    for (let t = 0; t < 1;) {
      let next = 1, follower = null;
      for (const line of lines) {
        if (!(line[1] > top[1])) continue;
        const below = top[0] - line[0];
        const crossing = Math.max(t, below / (below + (line[1] - top[1])));
        if (crossing < next || (follower && crossing === next && line[1] > follower[1])) {
          next = crossing;
          follower = line;
        }
      }
      const slope = top[1] - top[0];
      const y0 = top[0] + t * slope, y1 = top[0] + next * slope;
      const part = (next - t) * width, piece = part * (y0 + y1) / 2;
      area += piece;
      moment += piece * (from - edges[0] + t * width) + part * part * (y0 + 2 * y1) / 6;
      t = next;
      if (!follower) break;
      top = follower;
    }
  }
  return edges[0] - lo + (area > 0 ? moment / area : 0);
}
)";

constexpr std::string_view kGaussians = R"(
/* With Gaussians among the terms: between neighboring corners each set is a line or a part of a Gaussian without an
 * inflection. Where two of them meet is found by bisection, and what lies under a Gaussian by quadrature. */
function pieceAt(p, x) {
  const u = (x - p.mean) / p.sigma;
  return p.curved ? Math.exp(p.log - 0.5 * u * u) : p.y0 + p.slope * x;
}

function pieceSlope(p, x) {
  return p.curved ? -pieceAt(p, x) * (x - p.mean) / (p.sigma * p.sigma) : p.slope;
}

function apart(p, q, ofSlopes, x) {
  if (ofSlopes) return pieceSlope(p, x) - pieceSlope(q, x);
  if (!p.curved || !q.curved) return pieceAt(p, x) - pieceAt(q, x);
  const u = (x - p.mean) / p.sigma, v = (x - q.mean) / q.sigma;
  return (p.log - q.log) - 0.5 * (u - v) * (u + v);
}

function signChange(p, q, ofSlopes, left, right) {
  const rising = apart(p, q, ofSlopes, left) <= 0;
  for (;;) {
    const middle = left + (right - left) / 2;
    if (middle <= left || middle >= right) return middle;
    if ((apart(p, q, ofSlopes, middle) <= 0) === rising) left = middle;
    else right = middle;
  }
}

function addCuts(p, q, length, cuts) {
  let middle = length;
  if (p.curved && q.curved) {
    const pp = 1 / (p.sigma * p.sigma), qq = 1 / (q.sigma * q.sigma);
    if (pp !== qq) middle = (p.mean * pp - q.mean * qq) / (pp - qq);
  } else if ((apart(p, q, true, 0) <= 0) !== (apart(p, q, true, length) <= 0)) {
    middle = signChange(p, q, true, 0, length);
  }
  if (!(middle > 0 && middle < length)) middle = length;
  for (const [left, right] of [[0, middle], [middle, length]]) {
    if (!(left < right)) continue;
    if ((apart(p, q, false, left) <= 0) === (apart(p, q, false, right) <= 0)) continue;
    cuts.push(signChange(p, q, false, left, right));
  }
}

/* Ten points of Gauss and Legendre. */
const NODES = [0.14887433898163122, 0.43339539412924719, 0.67940956829902441, 0.86506336668898451, 0.97390652851717172];
const WEIGHTS = [0.29552422471475287, 0.26926671930999635, 0.21908636251598204, 0.14945134915058059,
                 0.06667134430868814];

function addCurve(p, from, to, start, sum) {
  for (let left = from; left < to;) {
    const right = Math.min(to, left + p.sigma * 2 / (1 + Math.abs(left - p.mean) / p.sigma));
    const half = (right - left) / 2;
    if (right <= left) return;
    for (let i = 0; i < 10; ++i) {
      const x = left + half + half * (i % 2 === 0 ? NODES[i >> 1] : -NODES[i >> 1]);
      const mass = half * WEIGHTS[i >> 1] * pieceAt(p, x);
      sum.area += mass;
      sum.moment += mass * (start + x);
    }
    left = right;
  }
}

function gaussianOffset(terms, strengths, largest, scales, lo, hi) {
  const within = (x) => Math.min(Math.max(x, lo), hi);
  const used = terms.map((term, i) => ({ term, strength: strengths[i] })).filter((one) => one.strength > 0);
  const edges = [];
  for (const one of used) {
    one.share = scales ? 1 : Math.max(one.strength / SCALE, LEAST);
    one.height = one.strength / largest;
    if (one.term.gaussian) {
      const flat = Math.sqrt(-2 * Math.log(one.share));
      for (const u of [-39, -flat, -1, 0, 1, flat, 39]) edges.push(within(one.term.gaussian[0] + u * one.term.gaussian[1]));
    } else {
      one.set = setOf(one.term.at, one.strength, largest, scales);
      for (const x of [one.set.left, one.set.topLeft, one.set.topRight, one.set.right]) edges.push(within(x));
    }
  }
  edges.sort(ascending);
  const sum = { area: 0, moment: 0 };
  for (let i = 1; i < edges.length; ++i) {
    const from = edges[i - 1], to = edges[i], length = to - from, start = from - edges[0];
    if (!(length > 0)) continue;
    const pieces = [];
    for (const one of used) {
      const line = { curved: false, mean: 0, sigma: 1, log: 0, y0: 0, slope: 0 };
      if (one.term.gaussian) {
        const [mean, sigma] = one.term.gaussian;
        const factor = one.height / one.share;
        const u = (from - mean + length / 2) / sigma;
        if (Math.abs(u) > 39) continue;
        const curved = Math.exp(-0.5 * u * u) * factor < one.height;
        pieces.push({ curved, mean: mean - from, sigma, log: Math.log(factor), y0: one.height, slope: 0 });
      } else if (one.set.left <= from && to <= one.set.right) {
        line.y0 = heightAt(one.set, from);
        line.slope = (heightAt(one.set, to) - line.y0) / length;
        pieces.push(line);
      }
    }
    if (pieces.length === 0) continue;
    const cuts = [0, length];
    pieces.forEach((p, k) => pieces.slice(k + 1).forEach((q) => addCuts(p, q, length, cuts)));
    cuts.sort(ascending);
    for (let k = 1; k < cuts.length; ++k) {
      const x0 = cuts[k - 1], x1 = cuts[k], middle = x0 + (x1 - x0) / 2;
      if (!(x1 > x0)) continue;
      const top = pieces.reduce((best, p) => (pieceAt(p, middle) > pieceAt(best, middle) ? p : best));
      if (top.curved) {
        addCurve(top, x0, x1, start, sum);
        continue;
      }
      const y0 = pieceAt(top, x0), y1 = pieceAt(top, x1), width = x1 - x0, piece = width * (y0 + y1) / 2;
      sum.area += piece;
      sum.moment += piece * (start + x0) + width * width * (y0 + 2 * y1) / 6;
    }
  }
  return edges[0] - lo + (sum.area > 0 ? sum.moment / sum.area : 0);
}
)";

constexpr std::string_view kMean = R"(
/* The centroid of one expert from the lower end of the output; null where no rule fires. at: from clamped. */
function offsetOf(model, expert, at) {
  const strengths = strengthsOf(model, expert, at);
  if (!strengths) return null;
  const terms = outputTerms(model, expert);
  const largest = Math.max(...strengths);
  const scales = model.implication === 'scale';
  const { min, max } = model.output;
@GAUSSIAN@
  const sets = [];
  terms.forEach((term, t) => {
    if (strengths[t] > 0) sets.push(setOf(term.at, strengths[t], largest, scales));
  });
  return trapezoidOffset(sets, min, max);
}

/* The averaged force. inputs: an array in the order of FORCE_MODEL.inputs; a value outside is clamped. fired: whether
 * a rule fires; elsewhere the force is the default. An input that is not finite gives NaN. model: another one of the
 * same shape. */
function forceModel(inputs, model = FORCE_MODEL) {
  const at = clamped(model, inputs);
  if (!at) return { force: NaN, fired: false };
  let mean = 0, weights = 0;
  for (const expert of model.experts) {
    const offset = expert.weight > 0 ? offsetOf(model, expert, at) : null;
    if (offset === null) continue;
    weights += expert.weight;
    mean += (offset - mean) * (expert.weight / weights);
  }
  return weights > 0 ? { force: model.output.min + mean, fired: true } : { force: model.default_force, fired: false };
}

/* The force of one expert alone. */
function forceModelExpert(expert, inputs, model = FORCE_MODEL) {
  if (!model.experts[expert]) return { force: 0, fired: false };
  const at = clamped(model, inputs);
  if (!at) return { force: NaN, fired: false };
  const offset = offsetOf(model, model.experts[expert], at);
  if (offset === null) return { force: model.default_force, fired: false };
  return { force: model.output.min + offset, fired: true };
}

if (typeof module === 'object' && module.exports) {
  module.exports = { FORCE_MODEL, forceModel, forceModelExpert };
} else {
  Object.assign(globalThis, { FORCE_MODEL, forceModel, forceModelExpert });
}
})();
)";

bool hasGaussianOutput(const fuzzy::ForceModel& model) {
  return std::any_of(model.experts.begin(), model.experts.end(), [&](const fuzzy::Expert& expert) {
    const auto& terms = fuzzy::termsFor(expert, model.output);
    return std::any_of(terms.begin(), terms.end(),
                       [](const fuzzy::Term& term) { return term.shape == fuzzy::Shape::kGaussian; });
  });
}

}  // namespace

std::string forAPage(std::string script) { return base::replaced(std::move(script), {{"</", "<\\/"}}); }

std::string jsForce(const fuzzy::ForceModel& model, const Origin& origin) {
  const bool gaussian = hasGaussianOutput(model);
  std::string out = "/* " + comment(model.name) +
                    ", written by Tactus. Plain JavaScript without any library: a module for Node, a script for a "
                    "page.\n *   const { force, fired } = forceModel([";
  for (std::size_t i = 0; i < model.inputs.size(); ++i) out += (i == 0 ? "" : ", ") + comment(model.inputs[i].id);
  out += "]);\n" + (origin.model_sha256.empty() ? "" : " * " + comment(originText(origin)) + "\n") +
         " */\n(function () {\n'use strict';\nconst FORCE_MODEL = " + modelText(model, origin);
  out.pop_back();
  out += ";\n" + std::string(kCentroid) + (gaussian ? std::string(kGaussians) : std::string());
  const std::string end = base::replaced(
      std::string(kMean),
      {{"@GAUSSIAN@\n", gaussian ? "  if (terms.some((term, t) => term.gaussian && strengths[t] > 0)) {\n"
                                   "    return gaussianOffset(terms, strengths, largest, scales, min, max);\n  }\n"
                                 : ""}});
  return forAPage(out + end);
}

}  // namespace tactus::exchange
