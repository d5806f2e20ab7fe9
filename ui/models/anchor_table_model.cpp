// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/models/anchor_table_model.h"

#include "ui/convert.h"
#include "ui/document/anchor_commands.h"
#include "ui/models/foreign_text.h"
#include "ui/models/limits_text.h"
#include "ui/models/number_text.h"

#include <QCoreApplication>
#include <QFont>
#include <QGuiApplication>
#include <QPalette>

#include <algorithm>
#include <limits>
#include <utility>

namespace cad2slam {
namespace {

bool isCoordinate(int column) {
  return column >= AnchorTableModel::kBlueprintX && column <= AnchorTableModel::kSlamY;
}

bool isNumber(int column) {
  return column == AnchorTableModel::kNumber || isCoordinate(column) || column == AnchorTableModel::kResidual ||
         column == AnchorTableModel::kLeaveOneOut;
}

double coordinate(const Anchor& anchor, int column) {
  switch (column) {
    case AnchorTableModel::kBlueprintX:
      return anchor.in_blueprint.x();
    case AnchorTableModel::kBlueprintY:
      return anchor.in_blueprint.y();
    case AnchorTableModel::kSlamX:
      return anchor.in_slam.x();
    default:
      return anchor.in_slam.y();
  }
}

QString shapeOf(AnchorClass judged) {  // the same shapes as in the views
  switch (judged) {
    case AnchorClass::kOk:
    case AnchorClass::kPlain:
      return QStringLiteral("●");
    case AnchorClass::kLook:
      return QStringLiteral("◆");
    case AnchorClass::kBad:
      return QStringLiteral("■");
    default:
      return QStringLiteral("○");
  }
}

}  // namespace

AnchorTableModel::AnchorTableModel(ProjectDocument& document, QObject* parent)
    : QAbstractTableModel(parent), document_(document), row_count_(static_cast<int>(document.anchors().size())) {
  connect(&document_, &ProjectDocument::changed, this, &AnchorTableModel::onChanged);
}

void AnchorTableModel::onChanged(const ChangeEvent& event) {
  const bool other_list =
      bool(event.what & (Change::kEverything | Change::kCurrentMap | Change::kSlamMaps | Change::kBlueprint));
  if (other_list || !event.added.empty() || !event.removed.empty()) {
    if (other_list) judgements_.clear();
    // One gesture may add or remove rows anywhere; a reset is cheaper than announcing every one of them.
    beginResetModel();
    row_count_ = static_cast<int>(document_.anchors().size());
    endResetModel();
  } else if (!event.edited.empty()) {
    int first = row_count_;
    int last = -1;
    for (const AnchorId id : event.edited) {
      const int row = rowOf(id).value_or(-1);
      if (row < 0) continue;
      first = std::min(first, row);
      last = std::max(last, row);
    }
    if (last >= 0) emit dataChanged(index(first, 0), index(last, kColumnCount - 1));
  }
}

void AnchorTableModel::setJudgements(std::map<AnchorId, AnchorJudgement> judgements, bool stale) {
  // Sorting and painting hundreds of rows takes milliseconds, and nothing is new with most changes of state.
  if (judgements == judgements_ && stale == stale_) return;
  judgements_ = std::move(judgements);
  stale_ = stale;
  if (row_count_ > 0) emit dataChanged(index(0, kResidual), index(row_count_ - 1, kFlag));
}

AnchorId AnchorTableModel::idOfRow(int row) const {
  const AnchorList& anchors = document_.anchors();
  return row >= 0 && row < static_cast<int>(anchors.size()) ? anchors[static_cast<std::size_t>(row)].id : -1;
}

std::optional<int> AnchorTableModel::rowOf(AnchorId id) const {
  const AnchorList& anchors = document_.anchors();
  for (std::size_t i = 0; i < anchors.size(); ++i)
    if (anchors[i].id == id) return static_cast<int>(i);
  return std::nullopt;
}

int AnchorTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : row_count_;
}
int AnchorTableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumnCount;
}

const AnchorJudgement* AnchorTableModel::judgementOf(AnchorId id) const {
  const auto found = judgements_.find(id);
  return found == judgements_.end() ? nullptr : &found->second;
}

QString AnchorTableModel::flagText(const Anchor& anchor) const {
  const AnchorJudgement* judgement = judgementOf(anchor.id);
  const AnchorClass judged = !anchor.enabled ? AnchorClass::kDisabled
                             : judgement     ? judgement->judged
                                             : AnchorClass::kPlain;
  QString word;
  switch (judged) {
    case AnchorClass::kOk:
      word = tr("OK");
      break;
    case AnchorClass::kLook:
      word = tr("look");
      break;
    case AnchorClass::kBad:
      word = tr("bad");
      break;
    case AnchorClass::kDisabled:
      word = tr("off");
      break;
    default:
      break;
  }
  QString text = shapeOf(judged);
  if (!word.isEmpty()) text += QLatin1Char(' ') + word;
  if (document_.isSnapped(anchor.id)) text += QStringLiteral(" ⌐");
  return text;
}

QVariant AnchorTableModel::display(const Anchor& anchor, int column) const {
  const AnchorJudgement* judgement = judgementOf(anchor.id);
  const auto centimetres = [](const std::optional<double>& value) {
    return value ? centimetresText(*value) : QStringLiteral("–");
  };
  switch (column) {
    case kNumber:
      return static_cast<qlonglong>(anchor.id);
    case kName:
      return toQString(anchor.name);
    case kResidual:
      return centimetres(judgement ? judgement->residual_m : std::nullopt);
    case kLeaveOneOut:
      return centimetres(judgement ? judgement->leave_one_out_m : std::nullopt);
    case kFlag:
      return flagText(anchor);
    case kNote:
      return toQString(anchor.note);
    default:
      return isCoordinate(column) ? QVariant(metresText(coordinate(anchor, column))) : QVariant();
  }
}

QVariant AnchorTableModel::sortValue(const Anchor& anchor, int column) const {
  const AnchorJudgement* judgement = judgementOf(anchor.id);
  const auto number = [](const std::optional<double>& value) {
    return value.value_or(-std::numeric_limits<double>::infinity());
  };
  switch (column) {
    case kEnabled:
      return anchor.enabled ? 1 : 0;
    case kResidual:
      return number(judgement ? judgement->residual_m : std::nullopt);
    case kLeaveOneOut:
      return number(judgement ? judgement->leave_one_out_m : std::nullopt);
    case kFlag:
      return judgement ? static_cast<int>(judgement->judged) : 0;
    default:
      return isCoordinate(column) ? QVariant(coordinate(anchor, column)) : display(anchor, column);
  }
}

QString AnchorTableModel::tooltip(const Anchor& anchor, int column) const {
  const AnchorJudgement* judgement = judgementOf(anchor.id);
  if (column == kLeaveOneOut && judgement && judgement->leave_one_out_m)
    return tr("Without anchor %1 the alignment would be off by %2 here")
        .arg(anchor.id)
        .arg(lengthAndPixels(*judgement->leave_one_out_m));
  if (column == kResidual && judgement && judgement->residual_m)
    return (judgement->is_check ? tr("Not used: the other anchors put this place %1 from where you clicked")
                                : tr("The alignment puts this place %1 from where you clicked"))
        .arg(lengthAndPixels(*judgement->residual_m));
  // Of any length, and mostly cut.
  if (column == kName || column == kNote) return asPlainText(toQString(column == kName ? anchor.name : anchor.note));
  if (column == kFlag && document_.isSnapped(anchor.id))
    return tr("The point is on a corner that was found in the image");
  if (column == kFlag && judgement && anchor.enabled && judgement->judged != AnchorClass::kPlain) return judgingText();
  if (!isCoordinate(column)) return {};
  const bool in_blueprint = column == kBlueprintX || column == kBlueprintY;
  const std::optional<MapFrame>& frame = frames_[in_blueprint ? 0 : 1];
  const QString metres = QCoreApplication::translate("units", "%1 m").arg(metresText(coordinate(anchor, column)));
  if (!frame) return metres;
  const Eigen::Vector2d pixel = frame->pixelFromMetric(in_blueprint ? anchor.in_blueprint : anchor.in_slam);
  return metres + QLatin1Char('\n') + tr("In the image at %1 px").arg(pairText(pixel.x(), pixel.y(), 1));
}

QString AnchorTableModel::judgingText() const {
  return limitsText(document_.state().limits) + QLatin1Char('\n') + badRuleText();
}

QString AnchorTableModel::lengthAndPixels(double length_m) const {
  if (!frames_[1]) return lengthText(length_m);
  return tr("%1 (%2 px)").arg(lengthText(length_m), numberText(length_m / frames_[1]->resolution(), 1));
}

void AnchorTableModel::setFrame(Side side, const std::optional<MapFrame>& frame) {
  frames_[side == Side::kBlueprint ? 0 : 1] = frame;
}

QVariant AnchorTableModel::data(const QModelIndex& index, int role) const {
  const AnchorList& anchors = document_.anchors();
  if (!index.isValid() || index.row() >= static_cast<int>(anchors.size())) return {};
  const Anchor& anchor = anchors[static_cast<std::size_t>(index.row())];
  const int column = index.column();
  switch (role) {
    case Qt::DisplayRole:
      return display(anchor, column);
    case Qt::EditRole:
      return isCoordinate(column) ? numberText(coordinate(anchor, column), 4) : display(anchor, column);
    case kSortRole:
      return sortValue(anchor, column);
    case kClassRole: {
      const AnchorJudgement* judgement = judgementOf(anchor.id);
      return judgement && anchor.enabled && !stale_ ? QVariant(static_cast<int>(judgement->judged)) : QVariant();
    }
    case Qt::CheckStateRole:
      return column == kEnabled ? QVariant(anchor.enabled ? Qt::Checked : Qt::Unchecked) : QVariant();
    case Qt::TextAlignmentRole:
      return isNumber(column) ? QVariant(int(Qt::AlignRight | Qt::AlignVCenter)) : QVariant();
    case Qt::ToolTipRole:
      return tooltip(anchor, column);
    case Qt::FontRole: {
      if (anchor.enabled) return {};
      QFont font;
      font.setItalic(true);
      return font;
    }
    case Qt::ForegroundRole: {
      const bool number_of_solve = column == kResidual || column == kLeaveOneOut || column == kFlag;
      const bool grey = !anchor.enabled || (stale_ && number_of_solve);
      return grey ? QVariant(QGuiApplication::palette().color(QPalette::PlaceholderText)) : QVariant();
    }
    case Qt::AccessibleTextRole:
      if (column == kEnabled)
        return anchor.enabled ? tr("anchor %1, used").arg(anchor.id) : tr("anchor %1, not used").arg(anchor.id);
      if (column == kFlag && document_.isSnapped(anchor.id))
        return QString(flagText(anchor) + QLatin1Char(' ') + tr("snapped"));
      return {};
    default:
      return {};
  }
}

bool AnchorTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const Anchor* anchor = index.isValid() ? document_.anchor(idOfRow(index.row())) : nullptr;
  if (!anchor || document_.isLocked()) return false;
  const AnchorId id = anchor->id;
  const int column = index.column();
  if (column == kEnabled && role == Qt::CheckStateRole) {
    edit::setEnabled(document_, {id}, value.toInt() == Qt::Checked);
    return true;
  }
  if (role != Qt::EditRole) return false;
  if (column == kName || column == kNote) {
    const std::string text = toStd(value.toString().trimmed());
    column == kName ? edit::rename(document_, id, text) : edit::setNote(document_, id, text);
    return true;
  }
  if (!isCoordinate(column)) return false;
  const std::optional<double> number = parseNumber(value.toString());
  if (!number) return false;
  // The editor shows fewer digits than the value has: leaving the text as it is must not round the anchor.
  if (value.toString() == data(index, Qt::EditRole).toString()) return true;
  Eigen::Vector2d in_blueprint = anchor->in_blueprint;
  Eigen::Vector2d in_slam = anchor->in_slam;
  Eigen::Vector2d& point = column <= kBlueprintY ? in_blueprint : in_slam;
  point[column == kBlueprintX || column == kSlamX ? 0 : 1] = *number;
  edit::setCoordinates(document_, id, in_blueprint, in_slam);
  return true;
}

QVariant AnchorTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::DisplayRole) {
    switch (section) {
      case kEnabled:
        return tr("On");
      case kNumber:
        return tr("#");
      case kName:
        return tr("Name");
      case kBlueprintX:
        return tr("Blueprint x (m)");
      case kBlueprintY:
        return tr("Blueprint y (m)");
      case kSlamX:
        return tr("SLAM map x (m)");
      case kSlamY:
        return tr("SLAM map y (m)");
      case kResidual:
        return tr("Residual (cm)");
      case kLeaveOneOut:
        return tr("Without it (cm)");
      case kFlag:
        return tr("Flag");
      case kNote:
        return tr("Note");
      default:
        return {};
    }
  }
  if (role == Qt::ToolTipRole) {
    switch (section) {
      case kEnabled:
        return tr("Whether the anchor takes part; one that does not is kept as a check (X)");
      case kResidual:
        return tr("Distance between where the alignment puts the anchor and where you clicked");
      case kLeaveOneOut:
        return tr("How far off the alignment would be here without this anchor (from 4 anchors on)");
      case kFlag:
        return QString(judgingText() + QLatin1Char('\n') + tr("○ Off; the limits are in the settings"));
      default:
        return {};
    }
  }
  return {};
}

Qt::ItemFlags AnchorTableModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemNeverHasChildren;
  if (document_.isLocked()) return flags;
  if (index.column() == kEnabled) flags |= Qt::ItemIsUserCheckable;
  if (index.column() == kName || index.column() == kNote || isCoordinate(index.column())) flags |= Qt::ItemIsEditable;
  return flags;
}

}  // namespace cad2slam
