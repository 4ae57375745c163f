// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulation3: the combinatorial part of a triangulation in space, closed to a sphere by a vertex
// at infinity. It knows cells and neighbours, never a coordinate.
//
// Cell c has four vertices in an order of one orientation, at the places 4c .. 4c + 3. Place f is
// also the name of the facet opposite its vertex:
//
//              p = apex(f)
//             /|\                   The facet f of a cell, opposite its apex p, is the facet
//            / | \                  mate(f) of the cell on the other side, opposite q = apex(mate(f)).
//           a--|--c   facet f       Replacing p by q in the order of a cell reverses its orientation.
//            \ | /
//              b
//
// A cell with the vertex at infinity is a ghost: its facet opposite infinity is on the hull. Each
// facet carries a label, 32 bits of the owner's, the same from both sides.
#ifndef KINEX_STRUCTURES_TRIANGULATION_TRIANGULATION_3_H
#define KINEX_STRUCTURES_TRIANGULATION_TRIANGULATION_3_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/motion/scene.h"
#include "structures/triangulation/edge_journal.h"

namespace kinex {

class Triangulation3 {
 public:
  using Cell = std::uint32_t;
  using Facet = std::uint32_t;
  using Quad = std::array<ObjectId, 4>;    // the vertices of a cell, in its order
  using Triple = std::array<ObjectId, 3>;  // the vertices of a facet, ascending
  static constexpr std::uint32_t kNone = 0xffffffffu;

  // Vertices are the ids 0 .. objects - 1; `objects` itself stands for infinity.
  explicit Triangulation3(std::size_t objects)
      : infinity_(static_cast<ObjectId>(objects)), cell_of_(objects + 1, kNone) {}

  ObjectId infinity() const { return infinity_; }
  // The finite edges that changes have touched.
  const EdgeJournal& journal() const { return journal_; }
  // O(cells).
  void clear();
  // The cell and the four ghosts on its facets. Requires an empty triangulation.
  void start(const Quad& cell);

  static Cell cell(Facet f) { return f / 4; }
  ObjectId apex(Facet f) const { return places_[f].vertex; }
  Facet mate(Facet f) const { return places_[f].mate; }
  std::uint32_t label(Facet f) const { return places_[f].label; }
  void set_label(Facet f, std::uint32_t label) {
    places_[f].label = label;
    places_[places_[f].mate].label = label;
  }
  Quad quad(Cell c) const {
    return {places_[4 * c].vertex, places_[4 * c + 1].vertex, places_[4 * c + 2].vertex,
            places_[4 * c + 3].vertex};
  }
  bool live(Cell c) const { return places_[4 * c].vertex != kNone; }
  // The place of a vertex in a cell that has it, or kNone.
  Facet place_of(Cell c, ObjectId v) const {
    for (Facet f = 4 * c; f < 4 * c + 4; ++f) {
      if (places_[f].vertex == v) return f;
    }
    return kNone;
  }
  bool ghost(Cell c) const { return place_of(c, infinity_) != kNone; }
  Triple triple(Facet f) const;
  bool has(ObjectId v) const { return cell_of_[v] != kNone; }
  Cell cell_of(ObjectId v) const { return cell_of_[v]; }
  // Vertices, not counting the one at infinity; cells, counting ghosts.
  std::size_t vertices() const { return vertices_; }
  std::size_t cells() const { return places_.size() / 4 - free_.size(); }
  // One past the largest cell ever used; not all below it are live.
  Cell cell_capacity() const { return static_cast<Cell>(places_.size() / 4); }
  void prefetch(Facet f) const { __builtin_prefetch(places_.data() + 4 * (f / 4), 1); }

  // The cells at a vertex, in no particular order that matters but the same in every run.
  void star(ObjectId v, std::vector<Cell>& out) const;
  // O(degree of a).
  bool adjacent(ObjectId a, ObjectId b) const;
  bool has_facet(ObjectId a, ObjectId b, ObjectId c) const;

  // The cells that have only vertices of the facet f and its two apices: two, or three if they are
  // around one edge; more where no flip is possible.
  struct Around {
    int cells = 2;
    Facet edge = kNone;  // of three cells: the place, in the cell of f, of the vertex opposite the
                         // edge in the facet
  };
  Around around(Facet f) const;

  // 2-3: the facet f of two cells is replaced by the edge between its apices. `fresh` receives three
  // facets inside, then six outside. Labels outside are kept; the first inside is that of f, the
  // others are kNone.
  void flip_2_3(Facet f, std::array<Facet, 9>& fresh);
  // 3-2: the edge of f opposite the place `out` of its cell, around which there are three cells, is
  // replaced by a facet. `gone` receives the labels of two of the three facets at the edge; the new
  // facet, fresh[0], has the label of f. Six facets outside follow.
  void flip_3_2(Facet f, Facet out, std::array<Facet, 7>& fresh,
                std::array<std::uint32_t, 2>& gone);

  // Replaces `cells` by cells with the vertices `quads`, which fill the same place: every facet is
  // in two cells, from opposite sides. Labels on the rim are kept; those inside are kNone. False,
  // with nothing changed, if they do not fit, or no ghost would be left. `fresh` receives the new
  // cells. O(k log k).
  bool replace(std::span<const Cell> cells, std::span<const Quad> quads, std::vector<Cell>& fresh);

  // +1 or -1: the orientation of the facet opposite place i, vertices ascending, in a cell. The two
  // cells of a facet have opposite ones.
  static int side(const Quad& quad, unsigned i);

  // Describes what is wrong with the links and counts; empty if nothing is.
  std::string defect() const;
  std::size_t bytes() const;

 private:
  struct Place {
    ObjectId vertex = kNone;
    Facet mate = kNone;
    std::uint32_t label = kNone;
  };
  struct Entry {  // a facet to be paired
    Triple triple;
    int side;
    Facet outside;  // on the rim: the facet there, else kNone
    std::uint32_t quad;
    std::uint32_t place;
  };
  void touch(ObjectId a, ObjectId b) {
    if (a != infinity_ && b != infinity_) journal_.touch(a, b);
  }
  // Those of old cells alone, or of new ones.
  void touch_changed(std::span<const Cell> cells, std::span<const Quad> quads);
  Cell allocate();
  void join(Facet f, Facet g, std::uint32_t label) {
    places_[f].mate = g;
    places_[f].label = label;
    places_[g].mate = f;
    places_[g].label = label;
  }
  std::uint32_t next_epoch() const;

  ObjectId infinity_;
  std::vector<Place> places_;
  std::vector<Cell> cell_of_;
  std::vector<Cell> free_;
  std::size_t vertices_ = 0;
  EdgeJournal journal_;
  // scratch
  mutable std::vector<std::uint32_t> mark_;
  mutable std::uint32_t epoch_ = 0;
  mutable std::vector<Cell> open_;
  std::vector<Entry> entries_;
};

}  // namespace kinex

#endif
