// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/anchor_panel.h"

#include "ui/models/limits_text.h"
#include "ui/models/number_text.h"
#include "ui/panels/coordinate_delegate.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QTableView>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

namespace cad2slam {
namespace {

QLabel* footerLabel(QHBoxLayout* layout, const QString& object_name, const QString& definition) {
  auto* label = new QLabel;
  label->setObjectName(object_name);
  label->setToolTip(definition);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout->addWidget(label);
  return label;
}

int widthInTwoLines(const QString& text, const QFontMetrics& metrics) {
  int narrowest = metrics.horizontalAdvance(text);
  for (qsizetype at = text.indexOf(QLatin1Char(' ')); at >= 0; at = text.indexOf(QLatin1Char(' '), at + 1))
    narrowest = std::min(
        narrowest, std::max(metrics.horizontalAdvance(text.left(at)), metrics.horizontalAdvance(text.mid(at + 1))));
  return narrowest;
}

/// With the mark of a snapped point.
int widestFlag(const QFontMetrics& metrics) {
  int widest = 0;
  for (const char* word : {"OK", "look", "bad", "off"})
    widest = std::max(widest, metrics.horizontalAdvance(AnchorTableModel::tr(word)));
  return widest + metrics.horizontalAdvance(QStringLiteral("◆  ⌐"));
}

}  // namespace

AnchorPanel::AnchorPanel(ProjectDocument& document, AnchorSelection& selection, QWidget* parent)
    : QWidget(parent), document_(document), selection_(selection), model_(document) {
  sorted_.setSourceModel(&model_);
  sorted_.setSortRole(AnchorTableModel::kSortRole);
  sorted_.setDynamicSortFilter(true);

  tool_bar_ = new QToolBar(this);
  tool_bar_->setIconSize({18, 18});

  table_ = new QTableView(this);
  table_->setObjectName(QStringLiteral("anchorTable"));
  table_->setAccessibleName(tr("Anchors"));
  table_->setModel(&sorted_);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  // Not AnyKeyPressed: single keys are shortcuts.
  table_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::SelectedClicked);
  table_->setSortingEnabled(true);
  table_->sortByColumn(AnchorTableModel::kNumber, Qt::AscendingOrder);
  table_->setAlternatingRowColors(true);
  table_->setWordWrap(false);
  table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 6);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->horizontalHeader()->setHighlightSections(false);
  // Headers of two lines: every number of an anchor is in sight without scrolling.
  const QFontMetrics metrics = table_->fontMetrics();
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignCenter | static_cast<Qt::Alignment>(Qt::TextWordWrap));
  table_->horizontalHeader()->setMinimumHeight(2 * metrics.height() + 8);
  table_->setItemDelegate(new CellDelegate(table_));
  table_->setItemDelegateForColumn(AnchorTableModel::kFlag, new FlagDelegate(table_));
  auto* delegate = new CoordinateDelegate(table_);
  const auto digits = [&](int count) { return metrics.horizontalAdvance(QLatin1Char('0')) * count; };
  for (int column = 0; column < AnchorTableModel::kColumnCount; ++column) {
    const QString header = model_.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    const int of_words = widthInTwoLines(header, metrics);
    const bool coordinate = column >= AnchorTableModel::kBlueprintX && column <= AnchorTableModel::kSlamY;
    const auto around = [&](const char* number) {
      return std::max(of_words, metrics.horizontalAdvance(QLatin1String(number))) + 10;
    };
    widths_[static_cast<std::size_t>(column)] = {around(coordinate ? "-1234.567" : "1234.5"),
                                                 around(coordinate ? "-123.456" : "123.4")};
  }
  widths_[AnchorTableModel::kEnabled] = {digits(5), digits(4)};
  widths_[AnchorTableModel::kNumber] = {digits(6), digits(4)};
  widths_[AnchorTableModel::kName] = {digits(10), digits(4)};
  widths_[AnchorTableModel::kFlag].wanted = widths_[AnchorTableModel::kFlag].least = widestFlag(metrics) + 10;
  widths_[AnchorTableModel::kNote].wanted = std::max(digits(8), widths_[AnchorTableModel::kNote].wanted);
  for (int column = AnchorTableModel::kBlueprintX; column <= AnchorTableModel::kSlamY; ++column)
    table_->setItemDelegateForColumn(column, delegate);
  fitColumns();
  table_->installEventFilter(this);
  table_->viewport()->installEventFilter(this);
  connect(table_->horizontalHeader(), &QHeaderView::sectionResized, this, [this](int column) {
    // The last one is resized by the table itself.
    if (!fitting_ && column != AnchorTableModel::kNote) sized_by_hand_ = true;
  });

  hint_ = new QLabel(tr("No anchors yet. Click a corner or pillar in either view, then the same place in the other."),
                     table_->viewport());
  hint_->setAlignment(Qt::AlignCenter);
  hint_->setWordWrap(true);
  hint_->setForegroundRole(QPalette::PlaceholderText);
  auto* over_table = new QVBoxLayout(table_->viewport());
  over_table->addWidget(hint_);

  auto* footer = new QHBoxLayout;
  footer->setContentsMargins(8, 2, 8, 4);
  footer->setSpacing(20);
  count_ = footerLabel(footer, QStringLiteral("footerCount"), tr("Anchors that take part, of all anchors"));
  rms_ = footerLabel(footer, QStringLiteral("footerRms"), tr("Root mean square of the residuals of the anchors used"));
  max_ = footerLabel(footer, QStringLiteral("footerMax"), tr("Largest residual of the anchors used"));
  leave_one_out_ = footerLabel(footer, QStringLiteral("footerLeaveOneOut"), {});
  footer->addStretch(1);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(tool_bar_);
  layout->addWidget(table_, 1);
  layout->addLayout(footer);

  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &AnchorPanel::takeSelection);
  connect(&selection_, &AnchorSelection::changed, this, &AnchorPanel::showSelection);
  connect(&model_, &QAbstractItemModel::modelAboutToBeReset, this, [this] { syncing_ = true; });
  connect(&model_, &QAbstractItemModel::modelReset, this, [this] {
    syncing_ = false;
    hint_->setVisible(model_.rowCount() == 0);
    showSelection();
  });
  connect(table_, &QTableView::doubleClicked, this,
          [this](const QModelIndex& index) { emit jumpRequested(model_.idOfRow(sorted_.mapToSource(index).row())); });
  setSummary({}, false);
}

void AnchorPanel::fitColumns() {
  if (sized_by_hand_) return;
  int missing = -table_->viewport()->width();
  for (const ColumnWidth& width : widths_) missing += width.wanted;
  fitting_ = true;
  const auto give = [&](int column, int parts) {
    const ColumnWidth& width = widths_[static_cast<std::size_t>(column)];
    const int given = std::clamp((missing + parts - 1) / parts, 0, width.wanted - width.least);
    missing -= given;
    if (column != AnchorTableModel::kNote) table_->setColumnWidth(column, width.wanted - given);
  };
  // What is read least gives way first; numbers that an anchor is judged by come last.
  give(AnchorTableModel::kNote, 1);
  give(AnchorTableModel::kName, 1);
  constexpr int kLastToGive = AnchorTableModel::kFlag;
  for (int column = 0; column <= kLastToGive; ++column)
    if (column != AnchorTableModel::kName) give(column, kLastToGive + 1 - column);
  fitting_ = false;
}

void AnchorPanel::takeSelection() {
  if (syncing_) return;
  std::vector<AnchorId> chosen;
  for (const QModelIndex& index : table_->selectionModel()->selectedRows())
    chosen.push_back(model_.idOfRow(sorted_.mapToSource(index).row()));
  // Keep the order of selection: what was selected before comes first.
  std::vector<AnchorId> ids = selection_.ids();
  std::erase_if(ids, [&](AnchorId id) { return std::find(chosen.begin(), chosen.end(), id) == chosen.end(); });
  for (const AnchorId id : chosen)
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
  const bool is_one = ids.size() == 1 && ids != selection_.ids();
  syncing_ = true;
  selection_.set(std::move(ids));
  syncing_ = false;
  if (is_one) emit jumpRequested(selection_.ids().front());
}

void AnchorPanel::showSelection() {
  if (syncing_) return;
  syncing_ = true;
  QItemSelection rows;
  QModelIndex current;
  for (const AnchorId id : selection_.ids()) {
    const std::optional<int> row = model_.rowOf(id);
    if (!row) continue;
    current = sorted_.mapFromSource(model_.index(*row, AnchorTableModel::kName));
    rows.select(current.siblingAtColumn(0), current.siblingAtColumn(AnchorTableModel::kColumnCount - 1));
  }
  if (current.isValid()) {
    const int column = table_->currentIndex().isValid() ? table_->currentIndex().column() : current.column();
    table_->selectionModel()->setCurrentIndex(current.siblingAtColumn(column), QItemSelectionModel::NoUpdate);
    table_->scrollTo(current.siblingAtColumn(column));
  }
  table_->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
  syncing_ = false;
}

void AnchorPanel::setSummary(const AlignmentSummary& summary, bool stale) {
  const auto length = [](const std::optional<double>& value) {
    return value ? lengthText(*value) : QStringLiteral("–");
  };
  count_->setText(tr("Used %1 of %2").arg(summary.used).arg(summary.total));
  rms_->setText(tr("RMS %1").arg(length(summary.rms_residual_m)));
  max_->setText(tr("Largest %1").arg(length(summary.max_residual_m)));
  leave_one_out_->setText(tr("Without-it median %1").arg(length(summary.median_leave_one_out_m)));
  leave_one_out_->setToolTip(
      tr("Middle of what each anchor would be missed by without itself: an honest guess of the error elsewhere") +
      QStringLiteral("\n\n") + limitsText(document_.state().limits) + QLatin1Char('\n') + badRuleText());
  for (QLabel* label : {count_, rms_, max_, leave_one_out_}) label->setEnabled(!stale);
}

std::optional<AnchorId> AnchorPanel::nextByError(std::optional<AnchorId> after, bool forward) const {
  std::vector<std::pair<double, AnchorId>> order;
  for (int row = 0; row < model_.rowCount(); ++row) {
    const auto value = [&](int column) {
      return model_.data(model_.index(row, column), AnchorTableModel::kSortRole).toDouble();
    };
    order.emplace_back(-std::max(value(AnchorTableModel::kLeaveOneOut), value(AnchorTableModel::kResidual)),
                       model_.idOfRow(row));
  }
  if (order.empty()) return std::nullopt;
  std::sort(order.begin(), order.end());
  const auto found = std::find_if(order.begin(), order.end(), [&](const auto& entry) { return entry.second == after; });
  if (!after || found == order.end()) return forward ? order.front().second : order.back().second;
  const std::size_t at = static_cast<std::size_t>(found - order.begin());
  return order[(at + (forward ? 1 : order.size() - 1)) % order.size()].second;
}

bool AnchorPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_->viewport() && event->type() == QEvent::Resize) fitColumns();
  if (watched == table_ && event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Space && key->modifiers() == Qt::NoModifier) {
      emit toggleRequested();
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace cad2slam
