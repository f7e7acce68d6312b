// The page of a study. `study` holds its rows; d3 stands before this.
(function () {
  'use strict';
  var colors = ['#0072b2', '#e69f00', '#009e73', '#cc79a7', '#d55e00', '#56b4e9', '#999999', '#f0e442'];

  // ---- Figures

  var byPlace = {};  // figures of a row, by measure, scene, design and memory
  study.rows.forEach(function (row) {
    byPlace[[row.measure, row.scene, row.design, row.memory].join('\n')] = row.figures;
  });
  function figures(measure, scene, design, memory) {
    return byPlace[[measure, scene, design, memory].join('\n')];
  }

  // What a design is compared by: a number of a design in the chosen scene, memory and technology, or
  // undefined where the study does not have it. `least`: smaller is better.
  function frame(d, c, measure) { return figures(measure, c.scene, d.name, c.memory); }
  function rate(d, c, count) {
    var cycles = frame(d, c, 'cycles'), timing = figures('timing', '', d.name, c.technology);
    return cycles && timing && cycles[count] * timing.fmax_mhz / cycles.cycles;
  }
  function area(d, c) {
    var a = figures('area', '', d.name, c.technology);
    return a && a.area_um2 / 1e6;
  }
  function error(name) {
    return function (d, c) {
      var e = figures('error', c.scene, d.name, '');
      return e && e[name];
    };
  }
  function perSecond(name) {
    return function (d, c) {
      var b = frame(d, c, 'bandwidth'), cycles = frame(d, c, 'cycles');
      var timing = figures('timing', '', d.name, c.technology);
      return b && cycles && timing && b[name] * timing.fmax_mhz / cycles.cycles;
    };
  }
  var metrics = [
    {name: 'cycles a frame', least: true, of: function (d, c) { var f = frame(d, c, 'cycles'); return f && f.cycles; }},
    {name: 'cycles a triangle', least: true, of: function (d, c) {
      var f = frame(d, c, 'cycles'); return f && f.cycles / f.triangles; }},
    {name: 'samples a cycle', of: function (d, c) { var f = frame(d, c, 'cycles'); return f && f.fragments / f.cycles; }},
    {name: 'M triangles/s', of: function (d, c) { return rate(d, c, 'triangles'); }},
    {name: 'M samples/s', of: function (d, c) { return rate(d, c, 'fragments'); }},
    {name: 'area, mm^2', least: true, of: area},
    {name: 'M samples/s/mm^2', of: function (d, c) {
      var r = rate(d, c, 'fragments'), a = area(d, c); return r && a && r / a; }},
    {name: 'clock, MHz', of: function (d, c) {
      var t = figures('timing', '', d.name, c.technology); return t && t.fmax_mhz; }},
    {name: 'depth error, ulp', least: true, of: error('depth_max_ulp')},
    {name: 'colour error, LSB', least: true, of: error('color_max_lsb')},
    {name: 'bytes read a frame', least: true, of: function (d, c) {
      var b = frame(d, c, 'bandwidth'); return b && b.bytes_read; }},
    {name: 'bytes written a frame', least: true, of: function (d, c) {
      var b = frame(d, c, 'bandwidth'); return b && b.bytes_written; }},
    {name: 'MB/s read', least: true, of: perSecond('bytes_read')},
    {name: 'MB/s written', least: true, of: perSecond('bytes_written')}
  ];

  var choice = {scene: study.scenes[0] || '', memory: study.memories[0] || '', technology: study.technologies[0] || ''};
  var pinned = null;

  function value(metric, design) {
    var v = metric.of(design, choice);
    return typeof v === 'number' && isFinite(v) ? v : undefined;
  }
  function known(metric) {
    return study.designs.some(function (d) { return value(metric, d) !== undefined; });
  }
  metrics = metrics.filter(known);
  function short(v) {
    if (v === undefined) return '\u2013';
    var a = Math.abs(v);
    if (a >= 1000) return d3.format(',.0f')(v);
    return a >= 100 ? v.toFixed(1) : a >= 10 ? v.toFixed(2) : a === 0 ? '0' : v.toPrecision(3);
  }

  // ---- Choices

  function select(id, label, options, chosen, changed) {
    if (options.length === 0) return;
    var box = d3.select('#' + id).append('label').text(label);
    var list = box.append('select').on('change', function () { changed(this.value); });
    list.selectAll('option').data(options).enter().append('option').attr('value', String).text(String)
        .property('selected', function (o) { return o === chosen; });
  }
  function metricNamed(name) { return metrics.filter(function (m) { return m.name === name; })[0]; }
  function first(names) {
    return names.map(metricNamed).filter(Boolean)[0] || metrics[0];
  }
  var axisX = first(['area, mm^2', 'cycles a triangle']);
  var axisY = first(['M samples/s', 'depth error, ulp', 'colour error, LSB', 'samples a cycle']);
  ['scene', 'memory', 'technology'].forEach(function (what) {
    var options = study[{scene: 'scenes', memory: 'memories', technology: 'technologies'}[what]];
    if (options.length < 2) return;
    select('choices', what, options, choice[what], function (v) { choice[what] = v; draw(); });
  });
  var names = metrics.map(function (m) { return m.name; });
  select('choices', 'across', names, axisX && axisX.name, function (v) { axisX = metricNamed(v); draw(); });
  select('choices', 'up', names, axisY && axisY.name, function (v) { axisY = metricNamed(v); draw(); });

  // ---- The plot of fronts

  var tip = d3.select('#tip');
  function showTip(text) {
    var box = document.body.getBoundingClientRect();
    tip.text(text).style('visibility', 'visible');
    var width = tip.node().offsetWidth;
    var x = Math.min(d3.event.pageX + 12, window.pageXOffset + box.right - width - 8);
    tip.style('left', Math.max(0, x) + 'px').style('top', (d3.event.pageY + 14) + 'px');
  }
  function hideTip() { tip.style('visibility', 'hidden'); }

  function scale(values, range) {
    var low = d3.min(values), high = d3.max(values);
    if (low > 0 && high / low > 12) return d3.scale.log().domain([low / 1.15, high * 1.15]).range(range);
    var room = (high - low || Math.abs(high) || 1) * .06;
    return d3.scale.linear().domain([low >= 0 ? Math.max(0, low - room) : low - room, high + room]).range(range);
  }
  function axis(scale, orient, ticks) {
    var a = d3.svg.axis().scale(scale).orient(orient).ticks(ticks);
    var tick = function (v) { return d3.format(Math.abs(v) >= 1 ? ',' : '')(+v.toPrecision(6)); };
    return a.tickFormat(scale.base ? function (v) { return scale.tickFormat(ticks)(v) ? tick(v) : ''; } : tick);
  }
  // Which points no other one beats in both.
  function front(points) {
    function better(metric, a, b) { return metric.least ? a <= b : a >= b; }
    return points.filter(function (p) {
      return !points.some(function (q) {
        return q !== p && better(axisX, q.x, p.x) && better(axisY, q.y, p.y) && (q.x !== p.x || q.y !== p.y);
      });
    }).sort(function (a, b) { return a.x - b.x; });
  }

  function canvas(id, title) {
    var width = Math.max(300, d3.select(id).node().clientWidth), height = Math.min(440, Math.max(300, width * .62));
    var margin = {top: 28, right: 14, bottom: 44, left: 62};
    d3.select(id).selectAll('svg').remove();
    var svg = d3.select(id).append('svg').attr('viewBox', '0 0 ' + width + ' ' + height).attr('role', 'group')
                  .attr('aria-label', title);
    return {svg: svg, left: margin.left, right: width - margin.right, top: margin.top, bottom: height - margin.bottom,
            ticks: width < 500 ? 4 : 7, width: width, height: height};
  }
  function axes(c, x, y, nameX, nameY) {
    c.svg.append('g').attr('class', 'axis').attr('transform', 'translate(0,' + c.bottom + ')').call(axis(x, 'bottom', c.ticks));
    c.svg.append('g').attr('class', 'axis').attr('transform', 'translate(' + c.left + ',0)').call(axis(y, 'left', c.ticks));
    c.svg.append('text').attr('class', 'soft').attr('x', c.right).attr('y', c.height - 6).attr('text-anchor', 'end').text(nameX);
    c.svg.append('text').attr('class', 'soft').attr('x', 4).attr('y', 14).text(nameY);
  }

  function drawFronts() {
    var points = study.designs.map(function (d) { return {design: d, x: value(axisX, d), y: value(axisY, d)}; })
                     .filter(function (p) { return p.x !== undefined && p.y !== undefined; });
    var c = canvas('#fronts', axisY.name + ' against ' + axisX.name + ', a point a design');
    d3.select('#no-points').style('display', points.length ? 'none' : null);
    if (points.length === 0) return;
    var x = scale(points.map(function (p) { return p.x; }), [c.left, c.right]);
    var y = scale(points.map(function (p) { return p.y; }), [c.bottom, c.top]);
    axes(c, x, y, axisX.name, axisY.name);
    var best = front(points);
    c.svg.append('path').attr('class', 'front').attr('d', d3.svg.line()
        .x(function (p) { return x(p.x); }).y(function (p) { return y(p.y); })(best));
    c.svg.selectAll('.point').data(points).enter().append('circle')
        .attr('class', function (p) {
          return 'point' + (best.indexOf(p) >= 0 ? ' on-front' : '') + (p.design === pinned ? ' pinned' : '');
        })
        .attr('r', 6).attr('cx', function (p) { return x(p.x); }).attr('cy', function (p) { return y(p.y); })
        .attr('tabindex', 0).attr('role', 'button')
        .attr('aria-label', function (p) {
          return p.design.name + ': ' + axisX.name + ' ' + short(p.x) + ', ' + axisY.name + ' ' + short(p.y);
        })
        .on('mousemove', function (p) { showTip(this.getAttribute('aria-label')); }).on('mouseleave', hideTip)
        .on('click', function (p) { pin(p.design); })
        .on('keydown', function (p) {
          if (d3.event.key !== 'Enter' && d3.event.key !== ' ') return;
          d3.event.preventDefault();
          pin(p.design);
        });
  }

  // ---- The design that is pinned

  function pin(design) {
    pinned = design;
    draw();
  }
  function addKey(key, name, i) {
    var one = key.append('span').attr('class', 'keyed');
    one.append('span').attr('class', 'key').style('background', colors[i % colors.length]);
    one.append('span').text(name);
    key.append('span').text(' ');
  }
  function bars(side, title, rows) {
    if (rows.length === 0) return;
    side.append('h4').text(title);
    var keys = [];
    rows.forEach(function (row) {
      var sum = d3.sum(row.parts, function (p) { return p.value; });
      if (!(sum > 0)) return;
      side.append('div').text(row.name);
      var bar = side.append('div').attr('class', 'bar').attr('role', 'img').attr('aria-label', row.parts.map(function (p) {
        return p.name + ' ' + (100 * p.value / sum).toFixed(1) + ' %';
      }).join(', '));
      row.parts.forEach(function (p, i) {
        if (keys.indexOf(p.name) < 0) keys.push(p.name);
        bar.append('span').style('width', 100 * p.value / sum + '%').style('background', colors[keys.indexOf(p.name) % colors.length])
            .attr('title', p.name + ' ' + (100 * p.value / sum).toFixed(1) + ' %');
      });
    });
    var key = side.append('div').attr('class', 'note');
    keys.forEach(function (name, i) { addKey(key, name, i); });
  }
  function drawSide() {
    var side = d3.select('#side');
    side.selectAll('*').remove();
    if (!pinned) {
      side.append('p').attr('class', 'note').text('Choose a design in the plot or in the table: what it does with its cycles, its area, its file.');
      return;
    }
    side.append('h3').text(pinned.name);
    var table = side.append('div').attr('class', 'scroll').append('table');
    metrics.forEach(function (m) {
      var row = table.append('tr');
      row.append('th').attr('scope', 'row').text(m.name);
      row.append('td').text(short(value(m, pinned)));
    });
    var stalls = figures('stalls', choice.scene, pinned.name, choice.memory);
    if (stalls) {
      bars(side, 'What each unit does in each cycle', ['setup', 'tiles', 'coverage', 'stamps', 'interp_ztest'].map(function (unit) {
        return {name: unit, parts: ['busy', 'starved', 'blocked', 'hazard', 'memory'].map(function (cause) {
          return {name: cause, value: stalls[unit + '.' + cause] || 0};
        })};
      }).filter(function (row) { return row.parts.some(function (p) { return p.value > 0; }); }));
    }
    var a = figures('area', '', pinned.name, choice.technology);
    if (a) {
      bars(side, 'Area', [{name: short(a.area_um2) + ' um^2', parts: Object.keys(a).filter(function (name) {
        return /\.area_um2$/.test(name);
      }).map(function (name) { return {name: name.replace('.area_um2', ''), value: a[name]}; })}]);
    }
    side.append('h4').text('Design file');
    var text = side.append('pre').text(pinned.toml);
    side.append('button').attr('class', 'copy').text('Copy').on('click', function () {
      var range = document.createRange();
      range.selectNodeContents(text.node());
      window.getSelection().removeAllRanges();
      window.getSelection().addRange(range);
      document.execCommand('copy');
      this.textContent = 'Copied';
    });
  }

  // ---- Cycles against the size of triangles

  function drawSizes() {
    var lines = study.designs.map(function (d) {
      return {design: d, points: study.scenes.map(function (scene) {
        var f = figures('cycles', scene, d.name, choice.memory);
        return f && f.fragments > 0 && {scene: scene, x: f.fragments / f.triangles, y: f.cycles / f.triangles};
      }).filter(Boolean).sort(function (a, b) { return a.x - b.x; })};
    }).filter(function (l) { return l.points.length > 1; });
    d3.select('#sizes-part').style('display', lines.length ? null : 'none');
    if (lines.length === 0) return;
    var c = canvas('#sizes', 'cycles a triangle against its covered samples, a line a design');
    var all = d3.merge(lines.map(function (l) { return l.points; }));
    var x = scale(all.map(function (p) { return p.x; }), [c.left, c.right]);
    var y = scale(all.map(function (p) { return p.y; }), [c.bottom, c.top]);
    axes(c, x, y, 'covered samples a triangle, by scene', 'cycles a triangle');
    var stamps = d3.set(study.designs.map(function (d) { return d.stamp; })).values().sort();
    var color = function (d) { return colors[stamps.indexOf(d.stamp) % colors.length]; };
    lines.forEach(function (l) {
      c.svg.append('path').attr('fill', 'none').attr('stroke', color(l.design))
          .attr('stroke-width', l.design === pinned ? 3 : 1.2).attr('stroke-opacity', l.design === pinned ? 1 : .6)
          .attr('d', d3.svg.line().x(function (p) { return x(p.x); }).y(function (p) { return y(p.y); })(l.points));
      c.svg.append('g').selectAll('circle').data(l.points).enter().append('circle').attr('r', 3).attr('fill', color(l.design))
          .attr('cx', function (p) { return x(p.x); }).attr('cy', function (p) { return y(p.y); })
          .on('mousemove', function (p) {
            showTip(l.design.name + ', ' + p.scene + ': ' + short(p.x) + ' samples, ' + short(p.y) + ' cycles a triangle');
          }).on('mouseleave', hideTip).on('click', function () { pin(l.design); });
    });
    var key = d3.select('#sizes-key');
    key.selectAll('*').remove();
    stamps.forEach(function (stamp, i) { addKey(key, stamp + ' px stamps', i); });
  }

  // ---- The table

  var order = {metric: null, up: true}, wanted = '';
  d3.select('#filter').on('input', function () { wanted = this.value.toLowerCase(); drawTable(); });
  function drawTable() {
    var head = d3.select('#designs thead'), body = d3.select('#designs tbody');
    head.selectAll('*').remove();
    body.selectAll('*').remove();
    var columns = [null].concat(metrics.filter(known));
    var row = head.append('tr');
    columns.forEach(function (m) {
      var cell = row.append('th').attr('scope', 'col');
      if (order.metric === m) cell.attr('aria-sort', order.up ? 'ascending' : 'descending');
      cell.append('button').text(m ? m.name : 'design').on('click', function () {
        order = {metric: m, up: order.metric === m ? !order.up : true};
        drawTable();
      });
    });
    var shown = study.designs.filter(function (d) { return d.name.toLowerCase().indexOf(wanted) >= 0; });
    shown.sort(function (a, b) {
      var va = order.metric ? value(order.metric, a) : a.name, vb = order.metric ? value(order.metric, b) : b.name;
      if (va === undefined || vb === undefined) return (va === undefined) - (vb === undefined);
      return (va < vb ? -1 : va > vb ? 1 : 0) * (order.up ? 1 : -1);
    });
    shown.forEach(function (d) {
      var line = body.append('tr').classed('pinned', d === pinned);
      line.append('th').attr('scope', 'row').append('button').text(d.name).on('click', function () { pin(d); });
      columns.slice(1).forEach(function (m) { line.append('td').text(short(value(m, d))); });
    });
    d3.select('#shown').text(shown.length + ' of ' + study.designs.length + ' designs');
  }

  function draw() {
    hideTip();
    if (axisX && axisY) drawFronts();
    drawSide();
    drawSizes();
    drawTable();
  }
  draw();
  var width = window.innerWidth;
  window.addEventListener('resize', function () {
    if (window.innerWidth === width) return;
    width = window.innerWidth;
    draw();
  });
}());
