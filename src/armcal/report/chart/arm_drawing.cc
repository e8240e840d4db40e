// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/chart/arm_drawing.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "armcal/report/chart/legend.h"
#include "armcal/report/chart/marks.h"
#include "armcal/report/chart/posture_drawing.h"
#include "armcal/report/chart/scale.h"
#include "armcal/report/label_places.h"

namespace armcal {
namespace {

constexpr double kDrawingWidth = 640.0, kDrawingHeight = 440.0;
constexpr double kSmallWidth = 480.0, kSmallHeight = 380.0;
constexpr double kDrawingMargin = 26.0;
constexpr double kFoot = 34.0;  // of scale bar and directions
constexpr double kElevation = 0.42;
constexpr int kAzimuths = 8;
// With steps of an eighth of a turn the eye is never within 17 deg of the ground's x or y axis.
constexpr double kFirstAzimuth = -1.08;
constexpr double kLongestArrow = 0.4;  // of the reach; what is longer is cut and dashed
constexpr double kLabelSize = 12.0;
constexpr double kLabelRoom = 16.0;  // at the right: faces wider than places are reckoned with
constexpr std::size_t kMostArtefactLabels = 40;

// The direction that is drawn upright: z of the base, where the first axis is about that, else the
// first axis.
Eigen::Vector3d up_of(const ArmModel& arm) {
  const Eigen::Vector3d axis = arm.base_from_first_joint.rotation.col(2);
  return std::abs(axis.z()) > 0.7 ? Eigen::Vector3d(Eigen::Vector3d::UnitZ()) : axis;
}

double length_seen(const StandingArm& arm, const SpaceView& view) {
  double length = 0.0;
  for (int i = 0; i < arm.joint_count(); ++i) {
    length += view.direction(arm.point(i + 1) - arm.point(i)).head<2>().norm();
  }
  return length;
}

SpaceView best_view(const StandingArm& arm, const Eigen::Vector3d& up) {
  SpaceView best(up, kFirstAzimuth, kElevation);
  for (int i = 1; i < kAzimuths; ++i) {
    const SpaceView view(up, kFirstAzimuth + 2.0 * std::numbers::pi * i / kAzimuths, kElevation);
    if (length_seen(arm, view) > 1.001 * length_seen(arm, best)) best = view;
  }
  return best;
}

// Draws a scene from far to near, labels last.
class SpaceDrawing {
 public:
  SpaceDrawing(double width, double height, const StandingArm& arm, const Eigen::Vector3d& up,
               double reach)
      : drawing_(width, height),
        labels_(width - kLabelRoom, height - kFoot),
        view_(best_view(arm, up)),
        reach_(reach),
        // A pedestal as high as the first joint stands above the base, and never none.
        ground_(std::min(0.0, up.dot(arm.point(0)) - 0.06 * reach)) {
    for (int i = 0; i <= arm.joint_count(); ++i) include(arm.point(i));
    include(on_ground(arm.point(0), up, ground_));
  }

  void include(const Eigen::Vector3d& point) {
    if (!point.allFinite()) return;
    view_.include(point);
    low_ = low_.cwiseMin(point);
    high_ = high_.cwiseMax(point);
  }

  void begin(double top) {
    view_.fit(kDrawingMargin, top + kDrawingMargin, drawing_.width() - kDrawingMargin,
              drawing_.height() - kFoot - kDrawingMargin);
    draw_grid();
  }

  void add(std::vector<PaintedPiece> pieces) {
    pieces_.insert(pieces_.end(), std::make_move_iterator(pieces.begin()),
                   std::make_move_iterator(pieces.end()));
  }
  void add(double nearness, std::string svg) { pieces_.push_back({nearness, std::move(svg)}); }

  void add_solid(const StandingArm& arm, int emphasised = -1) {
    drawing_.element(shadow(arm, view_, ground_));
    add(solid_pieces(arm, view_, ground_, emphasised));
    reserve(arm);
  }
  void reserve(const StandingArm& arm) {
    for (int i = 0; i < arm.joint_count(); ++i) {
      const Eigen::Vector2d from = at(arm.point(i));
      const Eigen::Vector2d to = at(arm.point(i + 1));
      labels_.reserve_line(from.x(), from.y(), to.x(), to.y());
      labels_.reserve(from.x(), from.y(), 9.0);
    }
    labels_.reserve(at(arm.tip_mm).x(), at(arm.tip_mm).y(), 5.0);
  }

  void label(const Eigen::Vector3d& point, const std::string& text, bool is_bold = false) {
    if (!text.empty()) wanted_.push_back({at(point), text, is_bold});
  }

  [[nodiscard]] SvgDrawing& drawing() { return drawing_; }
  [[nodiscard]] LabelPlaces& labels() { return labels_; }
  [[nodiscard]] const SpaceView& view() const { return view_; }
  [[nodiscard]] Eigen::Vector2d at(const Eigen::Vector3d& point) const { return view_.at(point); }

  [[nodiscard]] std::string finished(const std::string& title, const std::string& text) {
    std::stable_sort(
        pieces_.begin(), pieces_.end(),
        [](const PaintedPiece& a, const PaintedPiece& b) { return a.nearness < b.nearness; });
    for (const PaintedPiece& piece : pieces_) drawing_.element(piece.svg);
    draw_scale_bar();
    draw_directions();
    for (const Wanted& label : wanted_) {
      const std::string shown = shortened(label.text, 170.0, kLabelSize);
      const PlacedLabel placed = labels_.place(shown, label.at.x(), label.at.y());
      drawing_.text(placed.x, placed.y, shown,
                    {.size = kLabelSize, .has_halo = true, .is_bold = label.is_bold});
    }
    return drawing_.finished(title, text, "space");
  }

 private:
  struct Wanted {
    Eigen::Vector2d at;
    std::string text;
    bool is_bold;
  };

  // Squares of a nice size under everything that is included.
  void draw_grid() {
    const Eigen::Vector3d& up = view_.up();
    const Eigen::Vector3d first = std::abs(up.z()) > 0.9 ? Eigen::Vector3d(Eigen::Vector3d::UnitX())
                                                         : perpendicular_pair(up).first;
    const Eigen::Vector3d second = up.cross(first);
    double from[2] = {HUGE_VAL, HUGE_VAL};
    double to[2] = {-HUGE_VAL, -HUGE_VAL};
    for (int corner = 0; corner < 8; ++corner) {
      Eigen::Vector3d point = low_;
      for (int axis = 0; axis < 3; ++axis) {
        if ((corner >> axis & 1) != 0) point(axis) = high_(axis);
      }
      for (const int k : {0, 1}) {
        const double place = (k == 0 ? first : second).dot(point);
        from[k] = std::min(from[k], place);
        to[k] = std::max(to[k], place);
      }
    }
    const double step = nice_step(std::max(reach_, 1e-3) / 8.0);
    for (const int k : {0, 1}) {
      from[k] = std::floor(from[k] / step - 0.5);
      to[k] = std::min(std::ceil(to[k] / step + 0.5), from[k] + 60.0);
    }
    std::string lines;
    const auto place = [&](double i, double j) {
      const Eigen::Vector2d p = at(step * (i * first + j * second) + ground_ * up);
      return point(p.x(), p.y());
    };
    for (double i = from[0]; i <= to[0]; ++i) {
      lines += fmt::format("M{}L{}", place(i, from[1]), place(i, to[1]));
    }
    for (double j = from[1]; j <= to[1]; ++j) {
      lines += fmt::format("M{}L{}", place(from[0], j), place(to[0], j));
    }
    drawing_.path(lines, "class=\"grid\" stroke=\"currentColor\" stroke-opacity=\".14\"");
  }

  void draw_scale_bar() {
    const double most = 0.22 * drawing_.width() / view_.scale();
    const double length = 10.0 / nice_step(10.0 / most);
    const double y = drawing_.height() - 22.0;
    const double right = 12.0 + view_.scale() * length;
    drawing_.path(fmt::format("M{}v8M{}H{}M{}v8", point(12.0, y - 4.0), point(12.0, y),
                              coordinate(right), point(right, y - 4.0)),
                  "class=\"axis\" stroke=\"currentColor\" stroke-width=\"1.5\"");
    drawing_.text(12.0, y + 17.0, fmt::format("{:.6g} mm", length),
                  {.style = "tick", .size = kLabelSize});
  }

  // The axes of the base frame.
  void draw_directions() {
    const Eigen::Vector2d origin(drawing_.width() - 40.0, drawing_.height() - 26.0);
    constexpr const char* kNames[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d seen = view_.direction(Eigen::Vector3d::Unit(axis));
      const Eigen::Vector2d end = origin + 20.0 * seen.head<2>();
      drawing_.line(origin.x(), origin.y(), end.x(), end.y(),
                    "class=\"axis\" stroke=\"currentColor\" stroke-width=\"1.5\"");
      const Eigen::Vector2d name = origin + 28.0 * seen.head<2>();
      drawing_.text(name.x(), name.y() + 4.0, kNames[axis],
                    {.style = "tick", .anchor = TextAnchor::middle, .size = kLabelSize});
    }
  }

  SvgDrawing drawing_;
  LabelPlaces labels_;
  SpaceView view_;
  double reach_;
  double ground_;
  Eigen::Vector3d low_ = Eigen::Vector3d::Constant(HUGE_VAL);
  Eigen::Vector3d high_ = Eigen::Vector3d::Constant(-HUGE_VAL);
  std::vector<PaintedPiece> pieces_;
  std::vector<Wanted> wanted_;
};

// A residual of a posture, enlarged.
struct Arrow {
  Eigen::Vector3d from, to;
  bool is_check;
  bool is_cut;  // it would be longer
};

std::vector<Arrow> arrows_of(const ArmScene& scene) {
  const double longest = kLongestArrow * reach_mm(scene.arm);
  std::vector<Arrow> arrows;
  for (const ScenePosture& posture : scene.postures) {
    const auto arm = standing(scene.arm, posture.q_rad);
    if (!arm) continue;
    const Eigen::Vector3d residual = posture.residual_mm.value_or(Eigen::Vector3d::Zero());
    Eigen::Vector3d way = scene.enlargement * residual;
    if (!std::isfinite(way.norm())) way.setZero();
    const bool is_cut = way.norm() > longest;
    if (is_cut) way *= longest / way.norm();
    arrows.push_back({arm->tip_mm, arm->tip_mm + way, posture.is_check, is_cut});
  }
  return arrows;
}

std::string arrow_path(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const Eigen::Vector2d way = to - from;
  const double length = way.norm();
  if (length < 0.7) return "";
  const Eigen::Vector2d back = -std::min(5.0, 0.45 * length) / length * way;
  const Eigen::Vector2d side(-0.45 * back.y(), 0.45 * back.x());
  const auto xy = [](const Eigen::Vector2d& at) { return point(at.x(), at.y()); };
  return fmt::format("M{}L{}M{}L{}L{}", xy(from), xy(to), xy(to + back + side), xy(to),
                     xy(to + back - side));
}

std::string arrow_attributes(bool is_check) {
  return fmt::format("class=\"line s{}\" stroke=\"{}\" stroke-width=\"1.5\"", is_check ? 1 : 0,
                     series_colour(is_check ? 1 : 0));
}

// Tips and arrows of one kind on one side of the arm, as two paths.
void add_arrows(SpaceDrawing& space, const std::vector<Arrow>& arrows, double middle) {
  const double radius = std::min(2.6, mark_radius(arrows.size()));
  for (const bool is_near : {false, true}) {
    for (const bool is_check : {false, true}) {
      std::string lines;
      std::string cut;
      std::vector<DrawnPoint> tips;
      for (const Arrow& arrow : arrows) {
        const bool is_here =
            arrow.is_check == is_check && (space.view().nearness(arrow.from) > middle) == is_near;
        if (!is_here) continue;
        const Eigen::Vector2d from = space.at(arrow.from);
        tips.push_back({from.x(), from.y()});
        (arrow.is_cut ? cut : lines) += arrow_path(from, space.at(arrow.to));
      }
      if (tips.empty()) continue;
      const int style = is_check ? 1 : 0;
      std::string svg = fmt::format("<path d=\"{}\" {}/>\n", shapes_path(style, tips, radius),
                                    shape_attributes(style, radius));
      if (!lines.empty()) {
        svg += fmt::format("<path d=\"{}\" {}/>\n", lines, arrow_attributes(is_check));
      }
      if (!cut.empty()) {
        svg += fmt::format("<path d=\"{}\" stroke-dasharray=\"5 3\" {}/>\n", cut,
                           arrow_attributes(is_check));
      }
      space.add(is_near ? HUGE_VAL : -1e300, svg);
    }
  }
}

void add_artefacts(SpaceDrawing& space, const std::vector<SceneArtefact>& artefacts) {
  const std::string stroke = fmt::format("stroke=\"{}\"", series_colour(2));
  std::size_t labels = 0;
  for (const SceneArtefact& artefact : artefacts) {
    if (!artefact.at_mm.allFinite()) continue;
    const Eigen::Vector2d at = space.at(artefact.at_mm);
    const bool is_bar = artefact.shape == ArtefactShape::bar && artefact.to_mm.allFinite();
    const double radius = std::clamp(space.view().scale() * artefact.radius_mm,
                                     artefact.radius_mm > 0 ? 4.0 : 3.0, kDrawingHeight);
    std::string svg;
    if (is_bar) {
      const Eigen::Vector2d to = space.at(artefact.to_mm);
      svg = fmt::format(
          "<path class=\"artefact\" d=\"M{}L{}\" {} stroke-width=\"3\" "
          "stroke-linecap=\"round\"/>\n",
          point(at.x(), at.y()), point(to.x(), to.y()), stroke);
      space.labels().reserve_line(at.x(), at.y(), to.x(), to.y());
    } else if (artefact.shape == ArtefactShape::sphere) {
      svg = fmt::format(
          "<circle class=\"artefact\" cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\" "
          "fill-opacity=\".25\" {} stroke-width=\"1.5\"/>\n",
          coordinate(at.x()), coordinate(at.y()), coordinate(radius), series_colour(2), stroke);
    } else {
      svg = fmt::format("<path class=\"artefact\" d=\"M{}l5 -8h-10z\" fill=\"{}\" {}/>\n",
                        point(at.x(), at.y()), kPaperColour, stroke);
    }
    space.labels().reserve(at.x(), at.y(), std::min(radius, 20.0));
    space.add(space.view().nearness(artefact.at_mm), std::move(svg));
    if (++labels <= kMostArtefactLabels) space.label(artefact.at_mm, artefact.name);
  }
}

std::vector<LegendEntry> legend_of(const ArmDrawing& words) {
  std::vector<LegendEntry> entries;
  for (const bool is_check : {false, true}) {
    const std::string& name = is_check ? words.check : words.fit;
    const bool is_there =
        std::any_of(words.scene.postures.begin(), words.scene.postures.end(),
                    [&](const ScenePosture& posture) { return posture.is_check == is_check; });
    if (!is_there || name.empty()) continue;
    entries.push_back(
        {name, [is_check](SvgDrawing& drawing, double x, double y) {
           const DrawnPoint tip[] = {{x - 9.0, y}};
           drawing.path(shapes_path(is_check ? 1 : 0, tip, 2.6),
                        shape_attributes(is_check ? 1 : 0, 2.6));
           drawing.path(arrow_path({x - 9.0, y}, {x + 10.0, y}), arrow_attributes(is_check));
         }});
  }
  const bool has_arrows =
      std::any_of(words.scene.postures.begin(), words.scene.postures.end(),
                  [](const ScenePosture& posture) { return posture.residual_mm.has_value(); });
  if (has_arrows && !words.arrows.empty()) {
    entries.push_back({words.arrows, [](SvgDrawing& drawing, double x, double y) {
                         drawing.path(arrow_path({x - 10.0, y}, {x + 10.0, y}),
                                      "class=\"line\" stroke=\"currentColor\" "
                                      "stroke-width=\"1.5\"");
                       }});
  }
  return entries;
}

std::string svg_of(const ArmDrawing& words, const StandingArm& arm) {
  const ArmScene& scene = words.scene;
  SpaceDrawing space(kDrawingWidth, kDrawingHeight, arm, up_of(scene.arm), reach_mm(scene.arm));
  const std::vector<Arrow> arrows = arrows_of(scene);
  for (const Arrow& arrow : arrows) {
    space.include(arrow.from);
    space.include(arrow.to);
  }
  for (const SceneArtefact& artefact : scene.artefacts) {
    space.include(artefact.at_mm);
    if (artefact.shape == ArtefactShape::bar) space.include(artefact.to_mm);
  }
  const ChartLegend legend(legend_of(words), 6.0, kDrawingWidth - 6.0);
  space.begin(ChartLegend::kRowHeight * legend.rows());
  space.add_solid(arm);
  add_arrows(space, arrows, space.view().nearness(0.5 * (arm.point(0) + arm.tip_mm)));
  add_artefacts(space, scene.artefacts);
  for (int i = 0; i < arm.joint_count(); ++i) {
    space.label(arm.point(i), fmt::format("{}", i + 1), true);
  }
  legend.draw(space.drawing(), 17.0);
  return space.finished(words.title, words.text);
}

std::string svg_of(const HalfTurnDrawing& words, const StandingArm& a, const StandingArm& b) {
  const double reach = reach_mm(words.arm);
  SpaceDrawing space(kSmallWidth, kSmallHeight, a, up_of(words.arm), reach);
  for (int i = 0; i <= b.joint_count(); ++i) space.include(b.point(i));
  space.begin(0.0);
  const int joint = std::clamp(words.joint, 0, a.joint_count() - 1);
  space.add_solid(a, joint);
  space.reserve(b);
  space.add(-1e300, dashed_arm(b, space.view()));
  const Eigen::Vector3d along = 0.16 * reach * a.axes.col(joint);
  const Eigen::Vector2d from = space.at(a.point(joint) - along);
  const Eigen::Vector2d to = space.at(a.point(joint) + along);
  space.drawing().line(from.x(), from.y(), to.x(), to.y(),
                       fmt::format("class=\"line s1\" stroke=\"{}\" stroke-width=\"1.5\" "
                                   "stroke-dasharray=\"10 3 2 3\"",
                                   series_colour(1)));
  const Eigen::Vector2d start = space.at(a.tip_mm);
  const Eigen::Vector2d end = space.at(b.tip_mm);
  space.add(HUGE_VAL,
            fmt::format("<path class=\"line s0\" d=\"M{}L{}\" stroke=\"{}\" "
                        "stroke-width=\"1.8\" stroke-dasharray=\"3 3\"/>\n",
                        point(start.x(), start.y()), point(end.x(), end.y()), series_colour(0)));
  space.labels().reserve_line(start.x(), start.y(), end.x(), end.y());
  space.label(a.tip_mm, words.a_name, true);
  space.label(b.tip_mm, words.b_name, true);
  space.label(0.5 * (a.tip_mm + b.tip_mm), words.distance);
  space.label(a.point(joint), words.joint_name, true);
  return space.finished(words.title, words.text);
}

}  // namespace

Figure figure_of(const ArmDrawing& drawing) {
  Figure figure{.id = drawing.id,
                .title = drawing.title,
                .text = drawing.text,
                .svg = nothing_drawn(drawing.title, drawing.text, drawing.nothing)};
  const ArmScene& scene = drawing.scene;
  const auto stands = [&](const ScenePosture& posture) { return can_stand(scene.arm, posture); };
  auto shown = scene.postures.end();
  if (drawing.shown < scene.postures.size() && stands(scene.postures[drawing.shown])) {
    shown = scene.postures.begin() + static_cast<std::ptrdiff_t>(drawing.shown);
  } else {
    shown = std::find_if(scene.postures.begin(), scene.postures.end(), stands);
  }
  if (shown == scene.postures.end()) return figure;
  figure.svg = svg_of(drawing, *standing(scene.arm, shown->q_rad));
  figure.live = live_scene(scene);
  figure.is_wide = true;
  return figure;
}

Figure figure_of(const HalfTurnDrawing& drawing) {
  Figure figure{.id = drawing.id,
                .title = drawing.title,
                .text = drawing.text,
                .svg = nothing_drawn(drawing.title, drawing.text, drawing.nothing)};
  if (!problems_of(drawing.arm).empty()) return figure;
  const auto a = standing(drawing.arm, drawing.a_rad);
  const auto b = standing(drawing.arm, drawing.b_rad);
  if (!a || !b) return figure;
  figure.svg = svg_of(drawing, *a, *b);
  figure.live = live_scene({.arm = drawing.arm,
                            .postures = {{.name = drawing.a_name, .q_rad = drawing.a_rad},
                                         {.name = drawing.b_name, .q_rad = drawing.b_rad}},
                            .turning_joint = drawing.joint});
  return figure;
}

}  // namespace armcal
