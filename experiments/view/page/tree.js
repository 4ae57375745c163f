// The picture of a proof whose groups have places in trees: a tournament, a heap, a hull tree. A
// node has the objects that its group is about, a line to its parent, and a bar for its
// certificates. Beside trees of chains of points is the plane, with the chains of a node.
class Tree {
  constructor(app) {
    this.app = app;
    this.fit();
  }
  fit() { this.zoom = 1; this.dx = this.dy = 0; if (this.app.plane) this.app.plane.fit(); }

  // Nodes by place, with their depth and their position across: leaves are one apart.
  layout(proof) {
    const nodes = new Map();
    for (const group of proof.groups()) {
      if (group.place !== null) nodes.set(group.place, { group, children: [], depth: 0, across: 0 });
    }
    const roots = [];
    for (const node of nodes.values()) {
      const parent = nodes.get(node.group.parent);
      if (parent) parent.children.push(node); else roots.push(node);
    }
    const byPlace = (a, b) => a.group.branch - b.group.branch || a.group.place - b.group.place;
    let across = 0, deepest = 0;
    for (const root of roots.sort(byPlace)) {
      // In the order of a walk, without recursion: trees may be deep.
      const open = [[root, false]];
      while (open.length > 0) {
        const [node, done] = open.pop();
        if (done) {
          const xs = node.children.map(child => child.across);
          node.across = (Math.min(...xs) + Math.max(...xs)) / 2;
          continue;
        }
        deepest = Math.max(deepest, node.depth);
        if (node.children.length === 0) {
          node.across = across++;
          continue;
        }
        open.push([node, true]);
        node.children.sort(byPlace);
        for (const child of [...node.children].reverse()) {
          child.depth = node.depth + 1;
          open.push([child, false]);
        }
      }
      across += roots.length > 1 ? 0.8 : 0;
    }
    return { nodes: [...nodes.values()], across: Math.max(1, across - 1), deepest };
  }

  draw(picture) {
    const { app } = this, { proof } = app;
    const context = picture.begin();
    this.where = [];
    this.split = picture.width;
    if (proof === null || app.replay.lost) return;
    const tree = this.layout(proof);
    const chains = AXES > 1 && tree.nodes.some(({ group }) => group.marks.length > 0);
    if (chains) {
      this.split = Math.round(picture.width * 0.52);
      app.plane.drawIn(context, [this.split + 6, 20, picture.width - this.split - 6,
                                 picture.height - 20]);
      context.fillStyle = COLOUR.line;
      context.fillRect(this.split, 22, 1, picture.height - 22);
    }
    context.save();
    context.beginPath();
    context.rect(0, 0, this.split, picture.height);
    context.clip();
    this.place(tree, picture.height);
    this.drawEdges(context, tree);
    this.drawNodes(context, tree);
    context.restore();
  }

  place(tree, height) {
    const left = 34, top = 58, width = this.split - 2 * left, depth = height - top - 34;
    this.cx = left + width / 2;
    this.cy = top + depth / 2;
    this.step = width / tree.across * this.zoom;
    const rise = depth / Math.max(1, tree.deepest) * Math.min(this.zoom, 1.6);
    for (const node of tree.nodes) {
      node.x = this.cx + this.dx + (node.across / tree.across - 0.5) * width * this.zoom;
      node.y = this.cy + this.dy + (node.depth / Math.max(1, tree.deepest) - 0.5) *
        Math.min(rise * Math.max(1, tree.deepest), 78 * Math.max(1, tree.deepest));
    }
  }

  drawEdges(context, tree) {
    context.strokeStyle = COLOUR.quiet;
    context.globalAlpha = tree.nodes.length > 400 ? 0.3 : 0.6;
    context.lineWidth = 1;
    context.beginPath();
    for (const node of tree.nodes) {
      for (const child of node.children) {
        context.moveTo(node.x, node.y);
        context.lineTo(child.x, child.y);
      }
    }
    context.stroke();
    context.globalAlpha = 1;
    // The way of a winner: as its group is about the same objects.
    context.strokeStyle = COLOUR.first;
    context.lineWidth = 2.2;
    context.beginPath();
    for (const node of tree.nodes) {
      for (const child of node.children) {
        const { about } = node.group;
        if (about.length === 0 || child.group.about.join() !== about.join()) continue;
        context.moveTo(node.x, node.y);
        context.lineTo(child.x, child.y);
      }
    }
    context.stroke();
  }

  drawNodes(context, tree) {
    const { app } = this, { proof } = app;
    const next = proof.next(app.k);
    const soon = next === null ? -1 : proof.data.certificates[next[0]][0];
    const chosen = app.selectedGroup(), [gone, came] = proof.changeAt(app.k);
    const changed = new Set([...gone, ...came].map(c => proof.data.certificates[c][0]));
    const taken = [];
    for (const node of tree.nodes) {
      const { group, x, y } = node;
      const own = proof.certificatesOf(group.group).length;
      const is = chosen !== null && chosen.group === group.group;
      const colour = is ? COLOUR.selected : group.group === soon ? COLOUR.next
                   : changed.has(group.group) ? COLOUR.failed : COLOUR.point;
      const radius = is || group.group === soon ? 6.5 : own > 0 ? 4.6 : 3;
      this.where.push([node, x, y]);
      dot(context, x, y, radius + 1.5, COLOUR.back);
      dot(context, x, y, radius, colour);
      if (own === 0) dot(context, x, y, radius - 1.6, COLOUR.back);
      if (own > 1) label(context, "\u00d7" + own, x + radius + 3, y, COLOUR.quiet);
    }
    const rank = ({ group }) => (chosen !== null && chosen.group === group.group ? 0
                               : group.group === soon ? 1 : group.parent === null ? 2 : 3);
    for (const node of [...tree.nodes].sort((a, b) => rank(a) - rank(b) || a.depth - b.depth)) {
      const { group, x, y } = node;
      const root = group.parent === null, named = listOf(group.about);
      const text = named === "" ? (root ? group.kind + ", " : "") + group.text
                 : root && group.text !== "" ? named + " \u00b7 " + group.text : named;
      const half = context.measureText(text).width / 2 + 3;
      const below = node.children.length === 0, ty = y + (below ? 17 : -15);
      const box = [x - half, x + half, ty - 8, ty + 8];
      if (box[0] < 0 || box[1] > this.split) {
        if (group.parent !== null) continue;
      }
      if (taken.some(b => box[0] < b[1] && b[0] < box[1] && box[2] < b[3] && b[2] < box[3])) continue;
      taken.push(box);
      label(context, text, Math.max(half, Math.min(this.split - half, x)), ty,
            rank(node) === 0 ? COLOUR.selected : rank(node) === 1 ? COLOUR.next : COLOUR.text,
            "center");
    }
  }

  nodeAt(x, y) {
    let best = null, distance = 196;
    for (const [node, px, py] of this.where || []) {
      const d = (px - x) ** 2 + (py - y) ** 2;
      if (d < distance) { distance = d; best = node; }
    }
    return best;
  }
  nearest(x, y) {
    if (x > this.split) return this.app.plane.nearest(x, y);
    const node = this.nodeAt(x, y);
    return node !== null && node.group.about.length === 1 ? node.group.about[0] : null;
  }
  // The first certificate of the node; the node itself if it has none.
  certificateAt(x, y) {
    const { app } = this;
    if (x > this.split) return app.plane.certificateAt(x, y);
    const node = this.nodeAt(x, y);
    if (node === null) return null;
    app.chosenGroup = node.group.group;
    const own = app.proof.certificatesOf(node.group.group);
    return own.length > 0 ? own[0] : null;
  }
  scaleAbout(factor, x, y) {
    if (x > this.split) return this.app.plane.scaleAbout(factor, x, y);
    const cx = x - this.cx, cy = y - this.cy;
    this.dx = cx - (cx - this.dx) * factor;
    this.dy = cy - (cy - this.dy) * Math.min(factor, 1.2);
    this.zoom *= factor;
    return undefined;
  }
  move(dx, dy, x, y) {
    if (x > this.split) return this.app.plane.move(dx, dy);
    this.dx += dx;
    this.dy += dy;
    return undefined;
  }
}
