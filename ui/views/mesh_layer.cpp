// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/mesh_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <QLineF>

namespace cad2slam {
namespace {

constexpr int kColors = 21;
constexpr double kMargin = 0.15;          // of the view, on each side
constexpr double kShortestEdge_px = 2.0;  // below, an edge is a dot
constexpr std::size_t kSmoothEdges = 30'000;

/// Whether a picture shows all of a view at its zoom: panning within the margin needs no new one.
bool covers(const MeshLayer::Request& made, const MeshLayer::Request& wanted, const QSize& view) {
  if (made.mesh != wanted.mesh || made.ratio != wanted.ratio || made.state.m_per_px != wanted.state.m_per_px ||
      made.state.rotation_rad != wanted.state.rotation_rad) {
    return false;
  }
  const QPointF shift = made.state.widgetFromMetres(made.size).map(wanted.state.center_m) -
                        QPointF(made.size.width() / 2.0, made.size.height() / 2.0);
  return std::abs(shift.x()) <= (made.size.width() - view.width()) / 2.0 &&
         std::abs(shift.y()) <= (made.size.height() - view.height()) / 2.0;
}

bool sameRequest(const MeshLayer::Request& a, const MeshLayer::Request& b) {
  return a.mesh == b.mesh && a.state == b.state && a.size == b.size && a.ratio == b.ratio;
}

int colorIndex(const MeshOverlay& mesh, std::size_t edge, double full_strain) {
  if (mesh.strain.size() != mesh.edges.size()) return kColors / 2;
  const double part = mesh.strain[edge] / full_strain;
  if (!std::isfinite(part)) return kColors - 1;
  return static_cast<int>(std::lround((std::clamp(part, -1.0, 1.0) + 1.0) / 2.0 * (kColors - 1)));
}

void paintFolds(QPainter& painter, const MeshOverlay& mesh, const std::vector<QPointF>& nodes, const QRectF& area,
                double edge_px) {
  const double reach = std::clamp(edge_px * 0.5, 2.5, 9.0);
  std::vector<QLineF> crosses;
  for (const std::uint32_t node : mesh.folds) {
    if (node >= nodes.size() || !area.contains(nodes[node])) continue;
    const QPointF& at = nodes[node];
    crosses.emplace_back(at + QPointF(-reach, -reach), at + QPointF(reach, reach));
    crosses.emplace_back(at + QPointF(-reach, reach), at + QPointF(reach, -reach));
  }
  painter.setPen(QPen(Qt::black, 4.0));
  painter.drawLines(crosses.data(), static_cast<int>(crosses.size()));
  painter.setPen(QPen(QColor(0xff, 0xeb, 0x3b), 2.0));
  painter.drawLines(crosses.data(), static_cast<int>(crosses.size()));
}

}  // namespace

QColor strainColor(double strain, double full_color_strain) {
  const double part = std::clamp(strain / std::max(1e-6, full_color_strain), -1.0, 1.0);
  // Blue - grey - vermilion: told apart by every kind of colour vision, and by lightness at the ends.
  const std::array<double, 3> rest{105, 112, 120};
  const std::array<double, 3> shorter{0, 84, 200};
  const std::array<double, 3> longer{222, 70, 0};
  const auto& end = part < 0.0 ? shorter : longer;
  const double t = std::abs(part);
  const auto mix = [&](std::size_t i) { return static_cast<int>(std::lround(rest[i] + t * (end[i] - rest[i]))); };
  return QColor(mix(0), mix(1), mix(2));
}

double fullColorStrain(const MeshOverlay& mesh) {
  if (mesh.full_color_strain > 0.0) return mesh.full_color_strain;
  std::vector<float> sizes;
  for (const float strain : mesh.strain) {
    if (std::isfinite(strain)) sizes.push_back(std::abs(strain));
  }
  constexpr double kLeast = 0.01;
  if (sizes.empty()) return kLeast;
  const auto high = sizes.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), high, sizes.end());
  for (const double full : {kLeast, 0.02, 0.05, 0.1, 0.2}) {
    if (*high <= full) return full;
  }
  return 0.5;
}

MeshLayer::MeshLayer(std::function<void()> repaint)
    : repaint_(std::move(repaint)), job_(&MeshLayer::draw, [this](const Picture& picture) {
        picture_ = picture;
        repaint_();
      }) {}

void MeshLayer::setMesh(std::shared_ptr<const MeshOverlay> mesh) {
  mesh_ = std::move(mesh);
  if (!mesh_) {
    job_.cancel();
    picture_ = {};
    requested_ = {};
  }
}

MeshLayer::Picture MeshLayer::draw(const Request& request) {
  const MeshOverlay& mesh = *request.mesh;
  const QTransform widget_from_metres = request.state.widgetFromMetres(request.size);
  std::vector<QPointF> nodes(mesh.nodes_m.size());
  std::transform(mesh.nodes_m.begin(), mesh.nodes_m.end(), nodes.begin(),
                 [&](const QPointF& point) { return widget_from_metres.map(point); });

  const QRectF area = QRectF(QPointF(0, 0), QSizeF(request.size)).adjusted(-2, -2, 2, 2);
  std::array<std::vector<QLineF>, kColors> lines;
  std::size_t count = 0;
  const double full_strain = fullColorStrain(mesh);
  double length_sum = 0.0;
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const MeshOverlay::Edge& edge = mesh.edges[i];
    if (edge.from >= nodes.size() || edge.to >= nodes.size()) continue;
    const QLineF line(nodes[edge.from], nodes[edge.to]);
    if (std::max(line.x1(), line.x2()) < area.left() || std::min(line.x1(), line.x2()) > area.right() ||
        std::max(line.y1(), line.y2()) < area.top() || std::min(line.y1(), line.y2()) > area.bottom()) {
      continue;
    }
    const double length = line.length();
    if (!std::isfinite(length) || length > 1e5) continue;
    lines[static_cast<std::size_t>(colorIndex(mesh, i, full_strain))].push_back(line);
    length_sum += length;
    ++count;
  }

  Picture picture{request,
                  QImage((QSizeF(request.size) * request.ratio).toSize(), QImage::Format_ARGB32_Premultiplied)};
  picture.image.setDevicePixelRatio(request.ratio);
  picture.image.fill(Qt::transparent);
  QPainter painter(&picture.image);
  const double edge_px = count == 0 ? 0.0 : length_sum / static_cast<double>(count);
  const bool as_dots = edge_px * request.ratio < kShortestEdge_px;
  painter.setRenderHint(QPainter::Antialiasing, count < kSmoothEdges);
  if (edge_px > 9.0 && count < kSmoothEdges) {  // light edge below, for dark maps
    painter.setPen(QPen(QColor(255, 255, 255, 130), 3.0));
    for (const auto& group : lines) painter.drawLines(group.data(), static_cast<int>(group.size()));
  }
  for (int color = 0; color < kColors; ++color) {
    const auto& group = lines[static_cast<std::size_t>(color)];
    if (group.empty()) continue;
    const double strain = 2.0 * color / (kColors - 1.0) - 1.0;
    painter.setPen(QPen(strainColor(strain, 1.0), edge_px > 9.0 ? 1.4 : 1.0));
    if (as_dots) {
      std::vector<QPointF> middles(group.size());
      std::transform(group.begin(), group.end(), middles.begin(), [](const QLineF& line) { return line.center(); });
      painter.drawPoints(middles.data(), static_cast<int>(middles.size()));
    } else {
      painter.drawLines(group.data(), static_cast<int>(group.size()));
    }
  }
  paintFolds(painter, mesh, nodes, area, edge_px);
  return picture;
}

void MeshLayer::paint(QPainter& painter, const ViewState& state, const QSize& size) {
  if (!mesh_ || size.isEmpty()) return;
  const QSize margin(static_cast<int>(size.width() * kMargin), static_cast<int>(size.height() * kMargin));
  Request wanted{mesh_, state, size + 2 * margin, painter.device()->devicePixelRatioF()};
  if (!sameRequest(wanted, requested_) && !covers(requested_, wanted, size)) {
    requested_ = wanted;
    job_.request(wanted);
  }
  if (picture_.image.isNull()) return;
  const QTransform now = state.widgetFromMetres(size);
  const QTransform then = picture_.of.state.widgetFromMetres(picture_.of.size);
  painter.save();
  painter.setTransform(then.inverted() * now, true);
  painter.drawImage(QPointF(0, 0), picture_.image);
  painter.restore();
}

}  // namespace cad2slam
