// The contact boundaries that are pairs: which side is the slave, and what is opposite.

#include <stiction/base/log.h>
#include <stiction/base/text/in_words.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/pairs/held_slaves.h>
#include <stiction/contact/pairs/mortar.h>
#include <stiction/contact/pairs/smooth_parts.h>
#include <stiction/contact/pairs/surface_face.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <algorithm>
#include <set>
#include <utility>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    const std::string obstacle_entry = "Boundary conditions/Obstacle";

    // Of the area around a node of a pair: with less opposite it carries no forces.
    constexpr double least_cover = 1e-3;

    // Of what is covered, what may be so by several: edges that meet overlap by less.
    constexpr double covered_twice = 0.05;

    // Of the size of faces: what is between the sides of a tie counts as rigid.
    constexpr double widest_tie = 0.25;

    // Throws InputError if a tied pair is too far apart to be one.
    void require_close(const ContactBoundary &pair, const Mortar &mortar,
                       const std::vector<SurfaceFace> &slaves)
    {
      const double size = mean_diameter(slaves), distance = mortar.largest_gap();
      pair.source().require(
        distance <= widest_tie * size, "Friction/Law",
        "boundary '" + pair.name() + "' is up to " + format("%.3g", distance) +
          " away from '" + pair.partner_name() +
          "', to which it is tied, must be within " + format("%.3g", widest_tie * size) +
          ", a quarter of the size of its faces: what is between would count as rigid");
    }

    // Throws InputError if one of several that are opposite is not.
    void require_all_opposite(const LinearElasticity &elasticity,
                              const ContactBoundary &pair, const Mortar &mortar)
    {
      if (pair.partners().size() == 1)
        return;
      const std::set<types::global_dof_index> masters(mortar.masters.begin(),
                                                      mortar.masters.end());
      for (const auto id : pair.partners())
        {
          bool is_opposite = false;
          for (const SurfaceFace &face : surface_faces(elasticity, {id}))
            is_opposite =
              is_opposite ||
              std::all_of(face.dofs.begin(), face.dofs.begin() + face.n_nodes(),
                          [&](const auto dof) { return masters.count(dof) > 0; });
          pair.source().require(
            is_opposite, obstacle_entry,
            "nothing of '" + elasticity.body().boundary_names().name(id) +
              "' lies opposite to boundary '" + pair.name() + "', must be left out");
        }
    }

    // Throws InputError if supports hold nodes of the slave alone.
    void require_tie(const ContactBoundary &pair, const unsigned int n_held_alone)
    {
      pair.source().require(
        n_held_alone == 0, "Boundary conditions/Prescribed displacement",
        "holds " + std::to_string(n_held_alone) + " nodes of boundary '" + pair.name() +
          "', but not those of '" + pair.partner_name() +
          "' to which they are tied, so that the tie would be lost there, must hold "
          "both" +
          (pair.partners().size() == 1 ? ", or 'Slave side' must be the other one" : ""));
    }

    // Throws InputError if the sides of a pair overlap by more than a body is thick, all
    // over: two balls side by side do so where they look away from each other. And if
    // nothing is opposite, or several are to the same places.
    void require_side_by_side(const ContactBoundary &pair, const Mortar &mortar,
                              const std::vector<SurfaceFace> &slave,
                              const std::vector<SurfaceFace> &master)
    {
      pair.source().require(
        !mortar.slaves.empty() || !(mortar.deepest_left_out > 0.), obstacle_entry,
        "boundary '" + pair.name() + "' is " + format("%.3g", mortar.deepest_left_out) +
          " behind '" + pair.partner_name() + "', and a body of both is only " +
          format("%.3g", mortar.thickness) +
          " thick, must lie opposite to it but for a small interference");
      if (mortar.slaves.empty())
        pair.source().refuse(
          obstacle_entry,
          "boundary '" + pair.name() + "' has nothing of '" + pair.partner_name() +
            "' opposite: where they are nearest they " + why_not_opposite(slave, master));
      const Eigen::ArrayXd areas = mortar.areas.array().max(0.);
      const double twice         = ((mortar.covers.array() - 1.).max(0.) * areas).sum();
      pair.source().require(
        pair.partners().size() == 1 || twice <= covered_twice * areas.sum(),
        obstacle_entry,
        "of '" + pair.partner_name() +
          "' one lies behind another, must lie side by side: leave out what does not "
          "touch '" +
          pair.name() + "'");
    }

    using Boundaries = std::vector<types::boundary_id>;

    // Which boundaries bear the forces of a contact, and whose slaves bodies are.
    class Bearers
    {
    public:
      Bearers(const Body &body, const std::vector<ContactBoundary> &boundaries)
        : body_(body)
        , boundaries_(boundaries)
      {
        for (const ContactBoundary &boundary : boundaries)
          if (boundary.is_pair())
            {
              sides_.insert(boundary.id());
              sides_.insert(boundary.partners().begin(), boundary.partners().end());
              if (boundary.slave_side() == "obstacle")
                add_order(boundary.partners(), {boundary.id()});
              else if (boundary.slave_side() == "boundary")
                add_order({boundary.id()}, boundary.partners());
            }
          else
            bearing_.insert(boundary.id());
      }

      // The rank of a boundary that bears the forces of another contact.
      static constexpr unsigned int bears_already = 2;

      // Higher the more forces of other contacts one of them has to bear.
      unsigned int rank(const Boundaries &ids) const
      {
        unsigned int highest = 0;
        for (const auto id : ids)
          highest = std::max(highest, bearing_.count(id) > 0 ? bears_already
                                      : sides_.count(id) > 1 ? 1U
                                                             : 0U);
        return highest;
      }

      bool closes_circle(const Boundaries &slaves, const Boundaries &masters) const
      {
        return order_.closes_circle(bodies_at(slaves), bodies_at(masters));
      }

      // How each boundary bears the forces of one pair.
      std::string ways_to_do_so(const ContactBoundary &pair) const
      {
        const std::string way = pair.partners().size() == 1 ? "say the other side, " : "";
        for (const std::string &name : {pair.partner_name(), pair.name()})
          {
            std::string opposite;
            unsigned int n_pairs = 0;
            for (const ContactBoundary &other : boundaries_)
              if (other.is_pair() &&
                  (other.name() == name || other.partner_name() == name))
                opposite += (n_pairs++ == 0 ? "" : ", ") +
                            (other.name() == name ? other.partner_name() : other.name());
            if (n_pairs > 1)
              return way + "make one pair of '" + name + "' with '" + opposite + "', or ";
          }
        return way.empty() ? "" : way + "or ";
      }

      // Throws InputError if the slave of a pair bears other forces already.
      void require_one_contact(const ContactBoundary &pair) const
      {
        pair.source().require(
          bearing_.count(pair.id()) == 0, "Boundary conditions/Slave side",
          "boundary '" + pair.name() + "' would bear the forces of its pair with '" +
            pair.partner_name() + "' and those of another contact, must do so once: " +
            ways_to_do_so(pair) + "make boundaries of their own of the parts");
      }

      void add(const ContactBoundary &pair)
      {
        bearing_.insert(pair.id());
        add_order({pair.id()}, pair.partners());
      }

    private:
      SlaveOrder::Bodies bodies_at(const Boundaries &ids) const
      {
        SlaveOrder::Bodies bodies;
        for (const auto id : ids)
          bodies.merge(body_.pieces_at(id));
        return bodies;
      }

      void add_order(const Boundaries &slaves, const Boundaries &masters)
      {
        order_.add(bodies_at(slaves), bodies_at(masters));
      }

      const Body &body_;
      const std::vector<ContactBoundary> &boundaries_;
      std::multiset<types::boundary_id> sides_; // of all pairs
      std::set<types::boundary_id> bearing_;
      SlaveOrder order_;
    };

    // Whether either side may be the slave, as the user says: 'Initial gap' as a formula
    // is one of the places of the boundary itself.
    bool is_open(const ContactBoundary &pair)
    {
      return pair.slave_side() == "automatic" && pair.partners().size() == 1 &&
             !pair.has_gap_of_places();
    }

    // A pair whose slave side is to be chosen.
    struct Candidate
    {
      Candidate(const LinearElasticity &elasticity, const ContactBoundary &pair,
                const std::size_t its_number)
        : number(its_number)
        , first(surface_faces(elasticity, {pair.id()}))
        , second(surface_faces(elasticity, pair.partners()))
        , may_choose(is_open(pair))
        , best(may_choose
                 ? automatic_slave_side(elasticity, first, second, pair.is_tied())
                 : choose_slave_side(first, second))
      {
      }

      // Of 0 to 3: how little it matters which side is the slave.
      unsigned int freedom(const ContactBoundary &pair, const Bearers &bearers) const
      {
        return !may_choose                                                  ? 0
               : bearers.rank({pair.id()}) != bearers.rank(pair.partners()) ? 1
               : best.is_much_softer() || best.other("").is_much_softer()   ? 2
                                                                            : 3;
      }

      std::size_t number;
      std::vector<SurfaceFace> first, second;
      bool may_choose;
      SlaveSide best;
    };

    // All pairs, those of least freedom first: of the others, between two bodies each,
    // one side or the other then closes no circle, unless there is one without them.
    std::vector<Candidate> candidates(const LinearElasticity &elasticity,
                                      const std::vector<ContactBoundary> &boundaries,
                                      const Bearers &bearers)
    {
      std::vector<Candidate> pairs;
      for (std::size_t b = 0; b < boundaries.size(); ++b)
        if (boundaries[b].is_pair())
          pairs.emplace_back(elasticity, boundaries[b], b);
      const auto freedom = [&](const Candidate &pair) {
        return pair.freedom(boundaries[pair.number], bearers);
      };
      std::stable_sort(pairs.begin(), pairs.end(), [&](const auto &a, const auto &b) {
        return freedom(a) < freedom(b);
      });
      return pairs;
    }

    // The side that the user says, or the best one, unless another bears fewer forces or
    // closes no circle.
    SlaveSide choose_side(const ContactBoundary &pair, const Candidate &candidate,
                          const Bearers &bearers)
    {
      const SlaveSide &best = candidate.best;
      const Boundaries own{pair.id()};
      const Boundaries &slave  = best.is_first ? own : pair.partners();
      const Boundaries &master = best.is_first ? pair.partners() : own;
      const unsigned int rank = bearers.rank(slave), other = bearers.rank(master);
      SlaveSide side = best;
      if (!candidate.may_choose)
        {
          const bool is_best = (pair.slave_side() != "obstacle") == best.is_first;
          side               = is_best ? best : best.other("");
          side.reason        = pair.slave_side() != "automatic" ? "as 'Slave side' says"
                               : pair.partners().size() > 1
                                 ? "the side that is one boundary"
                                 : "the side of whose places 'Initial gap' is a formula";
        }
      else
        {
          const bool is_other = rank > other;
          if (is_other)
            side = best.other("the side that bears no other ones");
          const Boundaries &bears = is_other ? master : slave;
          const Boundaries &faces = is_other ? slave : master;
          if (!side.is_much_softer() && std::max(rank, other) < Bearers::bears_already &&
              bearers.closes_circle(bears, faces) && !bearers.closes_circle(faces, bears))
            side = side.other("or each of several bodies would bear forces of the next, "
                              "all the way round");
        }
      if (pair.wavers(side))
        side.reason +=
          ", although it is the stiffer one and its cells are not larger by "
          "a quarter: pressures waver, and newton multigrid takes many steps";
      return side;
    }

    // Whether supports hold another side less than the slave, which does not end within
    // it. Of contact it counts whether they hold nodes at all near the other side, which
    // is the same after the mesh is refined in the middle of a history.
    bool is_held_less(const LinearElasticity &elasticity, const ContactBoundary &pair,
                      const Mortar &mortar, const std::vector<SurfaceFace> &slave,
                      const std::vector<SurfaceFace> &other)
    {
      if (!pair.is_tied())
        return is_held(elasticity, slave, other) && !is_held(elasticity, other, slave) &&
               !ends_within(elasticity, slave, other);
      return n_held_alone(elasticity, mortar) > 0 &&
             n_held_alone(elasticity, Mortar(elasticity, other, slave)) == 0;
    }

    // Whether the other side would do where supports hold nodes of this one.
    bool may_change_sides(const ContactBoundary &pair, const SlaveSide &side,
                          const Bearers &bearers)
    {
      return pair.is_tied() ||
             (!side.is_much_softer() && bearers.rank(pair.partners()) == 0 &&
              !bearers.closes_circle(pair.partners(), {pair.id()}));
    }
  } // namespace

  void ContactSurface::join_pairs(const LinearElasticity &elasticity)
  {
    mortars_.resize(boundaries_.size());
    // a boundary that stands in several pairs can be the slave of one alone
    Bearers bearers(elasticity.body(), boundaries_);
    for (const ContactBoundary &boundary : boundaries_)
      if (!boundary.is_pair())
        parts_.split(surface_faces(elasticity, {boundary.id()}));
    for (Candidate &candidate : candidates(elasticity, boundaries_, bearers))
      {
        auto &[b, first, second, may_choose, best] = candidate;
        ContactBoundary &pair                      = boundaries_[b];
        SlaveSide side = choose_side(pair, candidate, bearers);
        pair.take_side(side);
        bearers.require_one_contact(pair);
        if (!side.is_first)
          std::swap(first, second);
        Mortar mortar(elasticity, first, second);
        if (pair.is_tied())
          require_close(pair, mortar, first);
        require_all_opposite(elasticity, pair, mortar);
        if (may_choose && may_change_sides(pair, side, bearers) &&
            !is_contact_boundary(pair.partners().front()) &&
            is_held_less(elasticity, pair, mortar, first, second))
          {
            std::swap(first, second);
            mortar = Mortar(elasticity, first, second);
            pair.take_side(side.other("the side that is held less"));
          }
        if (pair.is_tied())
          require_tie(pair, n_held_alone(elasticity, mortar));
        bearers.add(pair);
        require_side_by_side(pair, mortar, first, second);
        const auto parts =
          pair.is_tied() ? decltype(parts_.split(first)){first} : parts_.split(first);
        for (const auto &faces : parts)
          mortars_[b].push_back(parts.size() == 1 ? mortar
                                                  : Mortar(elasticity, faces, second));
      }
  }

  void ContactSurface::join_pairs_as(const ContactSurface &before)
  {
    mortars_ = before.mortars_;
    parts_   = before.parts_;
    for (std::size_t b = 0; b < boundaries_.size(); ++b)
      if (boundaries_[b].is_pair())
        boundaries_[b].take_side(before.boundaries_[b].side());
  }

  bool ContactSurface::place_in_pair(ContactNode &node) const
  {
    const Mortar &mortar            = mortars_[node.boundary][node.part];
    const Eigen::Index i            = mortar.row_of(node.first_dof);
    const ContactBoundary &boundary = boundary_of(node);
    if (i < 0 || std::abs(mortar.areas(i)) < least_cover * node.area ||
        (boundary.is_tied() && mortar.areas(i) < 0.) || mortar.is_of_both(node.first_dof))
      return false;
    node.cover           = mortar.areas(i) / node.area;
    node.area            = mortar.areas(i);
    node.mesh_gap        = mortar.gaps(i);
    node.facets          = mortar.facets;
    node.opposite_normal = to_tensor(mortar.normals.row(i).transpose());
    node.youngs_modulus  = std::min(node.youngs_modulus, mortar.youngs_moduli(i));
    node.gap             = boundary.initial_gap(node.position) +
               (boundary.keeps_mesh_gap() && !boundary.is_tied() ? node.mesh_gap : 0.);
    return true;
  }
} // namespace stiction
