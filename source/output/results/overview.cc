#include <stiction/base/log.h>
#include <stiction/base/units.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/loads.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/model/prescribed_displacement.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/output/results/overview.h>
#include <stiction/output/results/report.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/table_handler.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of the size of bodies: sides that were drawn where they touch are apart by less.
    constexpr double rounding_of_gap = 1e-12;

    void print(Log &log, const TableHandler &table)
    {
      std::stringstream out;
      table.write_text(out, TableHandler::org_mode_table);
      std::string line;
      while (std::getline(out, line))
        log.line("  " + line.substr(0, line.find_last_not_of(' ') + 1));
    }

    std::string number(const double value) { return format("%.4g", value); }

    // Components that are rounding, also of vectors of this size from which it
    // was computed, are zero.
    std::string vector(const Tensor<1, 3> &v, const double size = 0.)
    {
      return format_vector("%.4g", v, size);
    }

    Tensor<1, 3> sum_of_loads(const LinearElasticity &elasticity)
    {
      const Body &body = elasticity.body();
      Tensor<1, 3> sum;
      for (const Body::Node &node : body.locally_owned_nodes())
        for (unsigned int c = 0; c < 3; ++c)
          sum[c] += elasticity.load()(node.dofs[c]);
      return Utilities::MPI::sum(sum, body.communicator());
    }

    std::string describe(const Material &material)
    {
      const double lambda = material.lame_lambda, G = material.shear_modulus;
      return (material.is_isotropic
                ? "isotropic, E = " + number(material.youngs_modulus) +
                    ", nu = " + number(lambda / (2. * (lambda + G)))
                : "orthotropic, largest modulus " + number(material.youngs_modulus)) +
             (material.density > 0. ? ", density " + number(material.density)
                                    : std::string());
    }

    void print_box(Log &log, const dealii::BoundingBox<3> &box, const Units &units)
    {
      const auto corners = box.get_boundary_points();
      print_row(log, label("from", units.length), vector(corners.first));
      print_row(log, label("to", units.length), vector(corners.second));
    }

    // Volume and mass of each elastic body. Collective.
    std::vector<std::array<double, 2>> sizes(const LinearElasticity &elasticity)
    {
      const Body &body = elasticity.body();
      FEValues<3> values(body.mapping(), body.dof_handler().get_fe(),
                         QGauss<3>(body.dof_handler().get_fe().degree + 1),
                         update_JxW_values);
      std::vector<std::array<double, 2>> all(body.pieces().size());
      for (const auto &cell : body.locally_owned_cells())
        {
          values.reinit(cell);
          double volume = 0.;
          for (const double JxW : values.get_JxW_values())
            volume += JxW;
          auto &of_piece = all[body.piece_of(cell)];
          of_piece[0] += volume;
          of_piece[1] += volume * elasticity.materials().of(cell->material_id()).density;
        }
      for (auto &of_piece : all)
        for (double &sum : of_piece)
          sum = Utilities::MPI::sum(sum, body.communicator());
      return all;
    }

    void print_bodies(Log &log, const LinearElasticity &elasticity, const Units &units)
    {
      const auto &pieces = elasticity.body().pieces();
      if (pieces.size() == 1)
        {
          log.line("Body");
          print_box(log, elasticity.body().bounding_box(), units);
          return;
        }
      const auto all = sizes(elasticity);
      for (std::size_t p = 0; p < pieces.size(); ++p)
        {
          log.line("Body " + pieces[p].name);
          print_box(log, pieces[p].box, units);
          print_row(log, label("volume", units.length.empty() ? "" : units.length + "^3"),
                    number(all[p][0]));
          if (all[p][1] > 0.)
            print_row(log, "mass", number(all[p][1]));
        }
    }

    void print_boundaries(Log &log, const LinearElasticity &elasticity,
                          const ContactSurface &surface, const Units &units)
    {
      const Body &body = elasticity.body();
      TableHandler table;
      for (const auto &boundary : elasticity.loads().on_boundaries())
        {
          const std::string held =
            elasticity.prescribed_displacement().components(boundary.first);
          table.add_value("boundary", body.boundary_names().describe(boundary.first));
          table.add_value(label("area", units.area), number(boundary.second.area));
          table.add_value("prescribed", held.empty() ? "-" : held);
          table.add_value(label("resultant of its load", units.force),
                          boundary.second.force.norm() > 0.
                            ? vector(boundary.second.force)
                            : std::string("-"));
          const bool is_in_contact = surface.is_contact_boundary(boundary.first) ||
                                     surface.is_other_side(boundary.first);
          table.add_value("contact", std::string(is_in_contact ? "yes" : "-"));
        }
      log.line("Boundaries");
      print(log, table);

      log.line("  " + label("all loads, those inside the body too", units.force) + ": " +
               vector(sum_of_loads(elasticity)));
      const FreeMotions &motions = elasticity.free_motions();
      log.line(motions.n() > 0 ? "  the supports leave it free to " + motions.in_words()
                               : std::string("  the supports hold it"));
    }

    // @param rounding of gaps, m.
    void print_contact(Log &log, const ContactSurface &surface, const double rounding,
                       const Units &units)
    {
      // where the parameter file puts the obstacles, not where the search for
      // the place of a pressed one begins
      const Eigen::VectorXd gaps =
        surface.motion().offset_at_start().head(surface.n_nodes());
      TableHandler table;
      for (std::size_t b = 0; b < surface.boundaries().size(); ++b)
        {
          double smallest = std::numeric_limits<double>::max();
          double largest = -smallest, area = 0.;
          unsigned int n = 0, n_inside = 0;
          for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
            if (surface.nodes()[i].boundary == b)
              {
                const double gap = std::abs(gaps(i)) > rounding ? gaps(i) : 0.;
                ++n;
                n_inside += gap < 0. ? 1 : 0;
                area += surface.areas()(i);
                smallest = std::min(smallest, gap);
                largest  = std::max(largest, gap);
              }
          const ContactBoundary &boundary = surface.boundaries()[b];
          table.add_value("contact boundary", boundary.title());
          table.add_value("nodes", n);
          table.add_value(label("their area", units.area), number(area));
          table.add_value(label("smallest gap", units.length), number(smallest));
          table.add_value(label("largest gap", units.length), number(largest));
          table.add_value("nodes with interference", n_inside);
          const Tensor<1, 3> &force = surface.boundaries()[b].force();
          table.add_value(label("obstacle pressed on by", units.force),
                          force.norm() > 0. ? vector(force) : std::string("-"));
        }
      log.line("Contact");
      print(log, table);
    }
  } // namespace

  void print_applied(Log &log, const LinearElasticity &elasticity,
                     const ContactSurface &surface)
  {
    const Body &body                      = elasticity.body();
    const PrescribedDisplacement &support = elasticity.prescribed_displacement();
    const Loads &loads                    = elasticity.loads();
    const auto line = [&](const char *what, const std::string &text) {
      log.line(format("  %-10s ", what) + text);
    };

    log.line("Applied");
    for (const auto &place : support.description())
      line(place.second.find('=') == std::string::npos ? "held" : "moved",
           place.first + ": " + place.second);
    if (elasticity.free_motions().n() > 0)
      line("free",
           std::string(surface.slip_bound().has_tied()
                         ? "nothing but contact and ties hold the body where it can "
                         : "nothing but contact holds the body where it can ") +
             elasticity.free_motions().in_words());

    // with its rounding, for what is left of it
    Tensor<1, 3> inside = sum_of_loads(elasticity);
    const double size   = inside.norm();
    for (const auto &boundary : loads.on_boundaries())
      {
        inside -= boundary.second.force;
        const std::string text = loads.description(boundary.first);
        if (!text.empty())
          line("load", body.boundary_names().name(boundary.first) + ": " + text +
                         "; resultant " + vector(boundary.second.force));
      }
    if (!loads.description_inside().empty())
      line("load", "inside: " + loads.description_inside() + "; resultant " +
                     vector(inside, size));

    for (const ContactBoundary &boundary : surface.boundaries())
      line("contact",
           (boundary.section_name().empty() ? "" : boundary.section_name() + ": ") +
             boundary.name() + ": " + boundary.description());

    for (const auto id : body.material_names().ids())
      line("material", body.material_names().describe(id) + ": " +
                         describe(elasticity.materials().of(id)));
  }

  void print_overview(Log &log, const LinearElasticity &elasticity,
                      const ContactSurface &surface, const Units &units)
  {
    print_bodies(log, elasticity, units);
    print_boundaries(log, elasticity, surface, units);
    print_contact(log, surface, rounding_of_gap * elasticity.body().diameter(), units);
  }
} // namespace stiction
