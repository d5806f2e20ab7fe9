// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/document/app_state_json.h"

#include "ui/convert.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <cmath>

namespace cad2slam {
namespace {

constexpr double kLargestExactInteger = 9007199254740992.0;

AnchorId idOr(const QJsonValue& value, AnchorId fallback) {
  const double number = value.toDouble(-1.0);
  return number >= 0.0 && number < kLargestExactInteger ? static_cast<AnchorId>(number) : fallback;
}

double positiveOr(const QJsonValue& value, double fallback) {
  const double number = value.toDouble(fallback);
  return std::isfinite(number) && number > 0.0 ? number : fallback;
}

QJsonObject objectOf(const std::string& json) {
  return QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
}

QJsonObject withUnknownKeys(QJsonObject known, const QJsonObject& read) {
  for (auto each = read.begin(); each != read.end(); ++each)
    if (!known.contains(each.key())) known.insert(each.key(), each.value());
  return known;
}

}  // namespace

AppState appStateFromJson(const std::string& json) {
  const QJsonObject root = objectOf(json);
  AppState state;
  state.next_id = idOr(root[u"next_anchor_id"], 1);
  state.locked = root[u"locked"].toBool();
  state.current_map = toStd(root[u"current_map"].toString());
  state.views = root[u"views"].toObject();
  const QJsonObject limits = root[u"class_limits"].toObject();
  state.limits.ok_cells = positiveOr(limits[u"ok_cells"], state.limits.ok_cells);
  state.limits.ok_m = positiveOr(limits[u"ok_m"], state.limits.ok_m);
  state.limits.look_cells = positiveOr(limits[u"look_cells"], state.limits.look_cells);
  state.limits.look_m = positiveOr(limits[u"look_m"], state.limits.look_m);
  const QJsonObject snapped = root[u"snapped"].toObject();
  for (auto map = snapped.begin(); map != snapped.end(); ++map) {
    std::set<AnchorId> ids;
    for (const QJsonValue value : map.value().toArray()) ids.insert(idOr(value, 0));
    if (!ids.empty()) state.snapped.emplace(toStd(map.key()), std::move(ids));
  }
  return state;
}

std::string appStateToJson(const AppState& state, const std::string& read) {
  QJsonObject snapped;
  for (const auto& [map, ids] : state.snapped) {
    QJsonArray array;
    for (const AnchorId id : ids) array.append(static_cast<qint64>(id));
    snapped.insert(toQString(map), array);
  }
  const QJsonObject known_limits{{QStringLiteral("ok_cells"), state.limits.ok_cells},
                                 {QStringLiteral("ok_m"), state.limits.ok_m},
                                 {QStringLiteral("look_cells"), state.limits.look_cells},
                                 {QStringLiteral("look_m"), state.limits.look_m}};
  const QJsonObject before = objectOf(read);
  const QJsonObject limits = withUnknownKeys(known_limits, before[u"class_limits"].toObject());
  const QJsonObject root{{QStringLiteral("next_anchor_id"), static_cast<qint64>(state.next_id)},
                         {QStringLiteral("locked"), state.locked},
                         {QStringLiteral("current_map"), toQString(state.current_map)},
                         {QStringLiteral("class_limits"), limits},
                         {QStringLiteral("snapped"), snapped},
                         {QStringLiteral("views"), state.views}};
  return QJsonDocument(withUnknownKeys(root, before)).toJson(QJsonDocument::Compact).toStdString();
}

}  // namespace cad2slam
