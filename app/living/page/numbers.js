// What the section computes beside the force itself, without a page: a test runs it in Node against the evaluator.
(() => {
  'use strict';

  function membership(term, x) {
    if (term.gaussian) {
      const u = (x - term.gaussian[0]) / term.gaussian[1];
      return Math.exp(-0.5 * u * u);
    }
    const [a, b, c, d] = term.at;
    if (x < b) return x > a ? (x - a) / (b - a) : 0;
    if (x <= c) return 1;
    return x < d ? (d - x) / (d - c) : 0;
  }

  const labelOf = (thing) => thing.label || thing.id;
  const within = (variable, x) => Math.min(Math.max(x, variable.min), variable.max);

  /* The middle of a term's core inside the universe. */
  function coreMiddle(variable, term) {
    if (term.gaussian) return within(variable, term.gaussian[0]);
    return (within(variable, term.at[1]) + within(variable, term.at[2])) / 2;
  }

  /* The words that hold at x, the truest first: [label, membership]. */
  function wordsAt(variable, x) {
    const at = within(variable, x);
    return variable.terms.map((term) => [labelOf(term), membership(term, at)])
        .filter(([, share]) => share > 0.005)
        .sort((one, other) => other[1] - one[1]);
  }

  /* Where each word of a variable is the truest: [{label, from, to}], those that are nowhere left out. */
  function partsOf(variable) {
    const {min, max, terms} = variable, count = 1200, out = [];
    let before = -1;
    for (let i = 0; i <= count; ++i) {
      const x = min + (max - min) * i / count;
      const held = terms.map((term) => membership(term, x)), top = held.indexOf(Math.max(...held));
      if (held[top] === 0) {
        before = -1;
        continue;
      }
      if (top !== before) {
        if (before >= 0) out[out.length - 1].to = x;
        out.push({label: labelOf(terms[top]), from: x, to: x});
      }
      out[out.length - 1].to = x;
      before = top;
    }
    return out;
  }

  /* The strength of each output term of an expert. */
  function strengthsAt(model, expert, inputs) {
    const held = model.inputs.map(
        (input, i) => (expert.inputs[i] || input.terms).map((term) => membership(term, within(input, inputs[i]))));
    const out = (expert.output || model.output.terms).map(() => 0);
    for (const [then, weight, ...conditions] of expert.rules) {
      let least = 1;
      for (let k = 0; k < conditions.length; k += 2) least = Math.min(least, held[conditions[k]][conditions[k + 1]]);
      out[then] = Math.max(out[then], weight * least);
    }
    return out;
  }

  const NODES = [-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526];
  const WEIGHTS = [0.34785484513745385, 0.6521451548625461, 0.6521451548625461, 0.34785484513745385];

  /* The set under the largest of the terms, cut into slices: area and moment of each term, which is given the slices
   * where it is the largest, the first of equals. */
  function slicesOf(terms, strengths, scales, lo, hi) {
    const out = terms.map(() => ({area: 0, moment: 0}));
    const used = terms.map((term, t) => t).filter((t) => strengths[t] > 0);
    const height = (t, x) =>
        scales ? strengths[t] * membership(terms[t], x) : Math.min(strengths[t], membership(terms[t], x));
    const edges = [];
    for (const t of used) {
      const share = scales ? 1 : strengths[t];
      if (terms[t].gaussian) {
        const [mean, sigma] = terms[t].gaussian;
        const flat = Math.sqrt(-2 * Math.log(share));
        for (const u of [-39, -8, -4, -flat, -1, 0, 1, flat, 4, 8, 39]) edges.push(mean + u * sigma);
      } else {
        const [a, b, c, d] = terms[t].at;
        edges.push(a, a + share * (b - a), d - share * (d - c), d);
      }
    }
    const curved = used.some((t) => terms[t].gaussian);
    const places = [...new Set([lo, ...edges, hi].map((x) => Math.min(Math.max(x, lo), hi)))].sort((x, y) => x - y);
    const topAt = (x) => used.reduce((best, t) => (height(t, x) > height(best, x) ? t : best));

    function add(from, to) {
      const top = topAt(from + (to - from) / 2), half = (to - from) / 2;
      NODES.forEach((node, n) => {
        const x = from + half + half * node, mass = half * WEIGHTS[n] * height(top, x);
        out[top].area += mass;
        out[top].moment += mass * (x - lo);
      });
    }
    /* Straight lines cross where two points of each say so. */
    function crossings(from, to) {
      const width = to - from, x1 = from + width / 4, x2 = to - width / 4, cuts = [];
      used.forEach((t, k) => used.slice(k + 1).forEach((other) => {
        const near = height(t, x1) - height(other, x1), far = height(t, x2) - height(other, x2);
        const x = x1 + (x2 - x1) * near / (near - far);
        if (x > from && x < to) cuts.push(x);
      }));
      return cuts.sort((x, y) => x - y);
    }
    function signChange(from, to) {
      const first = topAt(from);
      for (let step = 0; step < 60; ++step) {
        const middle = from + (to - from) / 2;
        if (topAt(middle) === first)
          from = middle;
        else
          to = middle;
      }
      return to;
    }
    for (let i = 1; used.length > 0 && i < places.length; ++i) {
      let cuts = [];
      if (curved) {
        const parts = 48, at = (k) => places[i - 1] + (places[i] - places[i - 1]) * k / parts;
        for (let k = 0; k < parts; ++k) {
          cuts.push(at(k));
          if (topAt(at(k)) !== topAt(at(k + 1))) cuts.push(signChange(at(k), at(k + 1)));
        }
        cuts = cuts.slice(1);
      } else {
        cuts = crossings(places[i - 1], places[i]);
      }
      let from = places[i - 1];
      for (const to of [...cuts, places[i]]) {
        if (to > from) add(from, to);
        from = to;
      }
    }
    return out;
  }

  /* Why the force is what it is, as `tactus why` says it: share and pull of each word; the pulls sum to 0. */
  function balance(model, inputs, engine) {
    const whole = engine.forceModel(inputs, model);
    const words =
        new Map(model.output.terms.map((term) => [term.id, {label: labelOf(term), strength: 0, share: 0, pull: 0}]));
    const counted = model.experts.map((expert, e) => ({expert, own: engine.forceModelExpert(e, inputs, model)}))
                        .filter(({expert, own}) => expert.weight > 0 && own.fired);
    const weights = counted.reduce((sum, {expert}) => sum + expert.weight, 0);
    for (const {expert} of counted) {
      const terms = expert.output || model.output.terms;
      const strengths = strengthsAt(model, expert, inputs);
      const slices = slicesOf(terms, strengths, model.implication === 'scale', model.output.min, model.output.max);
      const area = slices.reduce((sum, one) => sum + one.area, 0) || 1;
      terms.forEach((term, t) => {
        if (!(strengths[t] > 0)) return;
        if (!words.has(term.id)) words.set(term.id, {label: labelOf(term), strength: 0, share: 0, pull: 0});
        const word = words.get(term.id), weight = expert.weight / weights;
        word.strength += weight * strengths[t];
        word.share += weight * slices[t].area / area;
        word.pull += weight * (slices[t].moment - (whole.force - model.output.min) * slices[t].area) / area;
      });
    }
    return {
      force: whole.force,
      fired: whole.fired,
      words: [...words].map(([id, word]) => ({id, ...word})).filter((word) => word.strength > 0)
    };
  }

  /* Where to begin: the middle words, in the region with the largest force. */
  function startPoint(model, region, engine) {
    const point = model.inputs.map((input) => coreMiddle(input, input.terms[Math.floor(input.terms.length / 2)]));
    if (region < 0) return point;
    const places = model.inputs[region].terms.map((term) => coreMiddle(model.inputs[region], term));
    const force = (x) => engine.forceModel(point.map((value, i) => (i === region ? x : value)), model).force;
    point[region] = places.reduce((best, x) => (force(x) > force(best) ? x : best));
    return point;
  }

  /* Positions along an input: even ones, and the corners of its words. */
  function positionsOf(model, input) {
    const {min, max, terms} = model.inputs[input];
    const out = Array.from({length: 241}, (_, i) => min + (max - min) * i / 240);
    for (const term of terms)
      if (term.at) out.push(...term.at.filter((x) => x > min && x < max));
    return out.sort((x, y) => x - y);
  }

  /* The force of the mean (expert null) or of one expert at the positions; null where no rule fires. */
  function curve(model, inputs, input, positions, expert, engine) {
    return positions.map((x) => {
      const point = inputs.map((value, i) => (i === input ? x : value));
      const one = expert === null ? engine.forceModel(point, model) : engine.forceModelExpert(expert, point, model);
      return one.fired ? one.force : null;
    });
  }

  /* The places of a variable's words that can be moved; words that meet at a place move together. */
  function cornersOf(variable) {
    const places = new Map();
    for (const term of variable.terms) {
      for (const x of term.gaussian ? [term.gaussian[0]] : term.at) {
        if (!(x > variable.min && x < variable.max)) continue;
        if (!places.has(x)) places.set(x, []);
        if (!places.get(x).includes(labelOf(term))) places.get(x).push(labelOf(term));
      }
    }
    return [...places].sort((one, other) => one[0] - other[0]).map(([x, words]) => ({x, words}));
  }

  /* Moves what stands at `from` to `to`, between the places beside it. Changes `variable`; returns where it stands now.
   */
  function moveCorner(variable, from, to) {
    const places = [variable.min, ...cornersOf(variable).map(({x}) => x), variable.max];
    const k = places.indexOf(from), gap = (variable.max - variable.min) / 500;
    const low = Math.min(places[k - 1] + gap, from), high = Math.max(places[k + 1] - gap, from);
    const x = Math.min(Math.max(to, low), high);
    for (const term of variable.terms) {
      if (term.gaussian && term.gaussian[0] === from) term.gaussian[0] = x;
      if (term.at) term.at = term.at.map((corner) => (corner === from ? x : corner));
    }
    return x;
  }

  /* Two digits after the point for a force of about 1. */
  function forceText(model, force) {
    const range = model.output.max - model.output.min;
    if (range > 1e6 || range < 1e-6) return force.toPrecision(2);
    return force.toFixed(Math.max(0, 2 - Math.floor(Math.log10(range) + 0.3)));
  }

  /* Three digits of the range of a variable. */
  function valueText(variable, x) {
    const range = variable.max - variable.min;
    if (range > 1e6 || range < 1e-6) return x.toPrecision(3);
    return String(Number(x.toFixed(Math.max(0, 2 - Math.floor(Math.log10(range))))));
  }

  function placeText(words) {
    if (words.length === 0) return '';
    const lower = words.map(([label, share]) => [label.toLowerCase(), share]);
    return lower.length > 1 && lower[1][1] > 0.3 ? 'between ' + lower[0][0] + ' and ' + lower[1][0] : lower[0][0];
  }

  /* "At 130 mm in the laryngopharynx, pushed at 250 mm/s, …: 0.65 N; the experts say 0.54 to 0.69 N." */
  function sentenceOf(model, places, inputs, engine) {
    const parts = [], last = [];
    model.inputs.forEach((input, i) => {
      const value = valueText(input, inputs[i]) + (input.unit && input.unit !== '1' ? ' ' + input.unit : '');
      const place = placeText(wordsAt(input, inputs[i]));
      const mixed = place.startsWith('between');
      if (i === places.region)
        parts.unshift('at ' + value + (place ? (mixed ? ' ' : ' in the ') + place : ''));
      else if (i === places.speed)
        parts.splice(places.region < 0 ? 0 : 1, 0, 'pushed at ' + value + (place ? ' (' + place + ')' : ''));
      else
        last.push(labelOf(input).toLowerCase() + ' ' + value + (place ? ' (' + place + ')' : ''));
    });
    const start = parts.concat(last).join(', ');
    const unit = model.output.unit;
    const whole = engine.forceModel(inputs, model);
    const head = start[0].toUpperCase() + start.slice(1) + ': ';
    if (!whole.fired)
      return head + 'no rule fires, so the force is the default, ' + forceText(model, whole.force) + ' ' + unit + '.';
    const own = model.experts.map((expert, e) => engine.forceModelExpert(e, inputs, model))
                    .filter((one) => one.fired)
                    .map((one) => one.force);
    const low = forceText(model, Math.min(...own)), high = forceText(model, Math.max(...own));
    const experts = model.experts.length < 2 ? '' :
        low === high                         ? '; the experts agree' :
                                               '; the experts say ' + low + ' to ' + high + ' ' + unit;
    return head + forceText(model, whole.force) + ' ' + unit + experts + '.';
  }

  /* CRC-32 as in zip: finds any changed byte, and any change within four bytes. */
  function crc32(text) {
    let rest = -1;
    for (const byte of new TextEncoder().encode(text)) {
      rest ^= byte;
      for (let bit = 0; bit < 8; ++bit) rest = (rest >>> 1) ^ (rest & 1 ? 0xEDB88320 : 0);
    }
    return (~rest >>> 0).toString(16).padStart(8, '0');
  }

  /* Computes every point of the checks again. One row a point: the inputs, and the force or "-" where no rule fires. */
  function checkAll(model, checks, engine) {
    const rows = checks.split(';').map((row) => row.split(','));
    // 1e-12 of the output's range, rounded down to a power of ten.
    const limit = Number('1e' + (Math.floor(Math.log10(model.output.max - model.output.min)) - 12));
    let worst = 0, wrong = 0;
    for (const row of rows) {
      const wanted = row[model.inputs.length];
      const found = engine.forceModel(row.slice(0, model.inputs.length).map(Number), model);
      const off = wanted === '-' ? (found.fired ? Infinity : 0) :
          found.fired            ? Math.abs(found.force - Number(wanted)) :
                                   Infinity;
      if (!(off <= limit)) ++wrong;
      worst = Math.max(worst, off);
    }
    return {count: rows.length, wrong, worst, limit};
  }

  globalThis.livingNumbers = {
    membership,
    labelOf,
    within,
    coreMiddle,
    wordsAt,
    partsOf,
    balance,
    startPoint,
    positionsOf,
    curve,
    cornersOf,
    moveCorner,
    forceText,
    valueText,
    placeText,
    sentenceOf,
    crc32,
    checkAll
  };
})();
