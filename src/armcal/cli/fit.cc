// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "armcal/cli/commands.h"
#include "armcal/cli/table_flags.h"
#include "armcal/report/fit_report.h"
#include "armcal/workflow/input_files.h"

namespace armcal::cli {
namespace {

struct FitFlags {
  std::string element;
  std::string points;
  bool plane_first = false;
  std::optional<double> u_mm;
  TableFlags table;
};

template <typename Fit>
int emit_fit(const Fit& fit, const FitFlags& flags, InputFiles& files, const Context& context) {
  if (!fit.ok()) {
    throw NumericalError(
        fmt::format("{}: no {} fits: {}", flags.points, flags.element, explain(fit.status)));
  }
  context.emit(files.records(), files.diagnostics(), json_result(fit), text_result(fit));
  return kDone;
}

CircleFit circle_of(const PointReadings& readings, const FitFlags& flags,
                    const FitOptions& options) {
  if (readings.planar) {
    std::vector<Eigen::Vector2d> points;
    for (const Eigen::Vector3d& p : readings.points_mm) points.emplace_back(p.x(), p.y());
    return fit_circle(points, options);
  }
  const auto method = flags.plane_first ? CircleMethod::plane_first : CircleMethod::orthogonal;
  return fit_circle(readings.points_mm, {options, method});
}

int run_fit(const FitFlags& flags, const Context& context) {
  if (flags.plane_first && flags.element != "circle") {
    throw std::invalid_argument(
        fmt::format("--plane-first is for circles: a {} has no plane of its own", flags.element));
  }
  InputFiles files(context.monitor);
  const auto readings = files.points(flags.points, flags.table.options());
  files.require_good();
  const FitOptions options{.u_point_mm = flags.u_mm};
  if (flags.element == "circle")
    return emit_fit(circle_of(*readings, flags, options), flags, files, context);
  const auto& points = readings->points_mm;
  if (flags.element == "sphere")
    return emit_fit(fit_sphere(points, options), flags, files, context);
  if (flags.element == "plane") return emit_fit(fit_plane(points, options), flags, files, context);
  return emit_fit(fit_line(points, options), flags, files, context);
}

}  // namespace

Command fit_command() {
  const auto flags = std::make_shared<FitFlags>();
  Command command;
  command.name = "fit";
  command.brief = "best-fit circle, sphere, plane or line through points";
  command.description =
      "Least squares of the orthogonal distances, with covariance. Points: columns x_mm, y_mm and "
      "z_mm (a circle also\n"
      "x_mm and y_mm alone). Exit code 4 where the points do not determine the element, with the "
      "reason.";
  command.arguments = joined(
      {{"ELEMENT",
        "what to fit",
        &flags->element,
        "",
        NumberRange::any,
        {"circle", "sphere", "plane", "line"}},
       {"POINTS.csv", "table of points; - for standard input", &flags->points},
       {"--plane-first", "circle: fit the plane first, then the circle of the projected points",
        &flags->plane_first},
       {"--u", "standard uncertainty of each coordinate, mm; else from the scatter", &flags->u_mm,
        "MM", NumberRange::positive}},
      flags->table.for_points());
  command.examples = {
      "armcal fit circle examples/points/gander1994.csv",
      "armcal fit sphere examples/points/sphere.csv --json",
      "armcal fit plane examples/points/surface-plate-german.csv --map x_mm=X,y_mm=Y,z_mm=Z"};
  command.run = [flags](const Context& context) { return run_fit(*flags, context); };
  return command;
}

}  // namespace armcal::cli
