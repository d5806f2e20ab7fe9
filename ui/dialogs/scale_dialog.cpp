// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/scale_dialog.h"

#include "ui/convert.h"
#include "ui/models/number_text.h"
#include "ui/services/tile_pyramid.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>

namespace cad2slam {

ScaleDialog::ScaleDialog(QWidget* parent, const std::filesystem::path& image, Side side)
    : QDialog(parent), picture_(TilePyramid::load(image)), view_(new MapView(this)) {
  setWindowTitle(side == Side::kBlueprint ? tr("Scale of the blueprint") : tr("Scale of the SLAM map"));
  resize(820, 640);
  auto* text = new QLabel(tr("%1 does not tell its scale. Type it, or click both ends of something whose length you "
                             "know and type that length.")
                              .arg(toQString(image.filename())));
  text->setTextFormat(Qt::PlainText);
  text->setWordWrap(true);

  view_->setSnapping(false);
  view_->setMinimumHeight(360);
  const auto show_picture = [this] {
    // One metre for each pixel: lengths in this view are pixels.
    const auto frame = MapFrame::create(1.0, picture_->size().width(), picture_->size().height(), Pose2{});
    if (!frame) return;
    view_->setFrame(*frame);
    view_->setImage(picture_);
    view_->fit();
    refresh();
  };
  if (picture_->size().isEmpty()) {
    connect(picture_.get(), &TilePyramid::sizeKnown, this, show_picture);
  } else {
    show_picture();
  }
  connect(picture_.get(), &TilePyramid::failed, this,
          [this](const QString& sentence) { measured_->setText(sentence); });
  connect(view_, &MapView::clicked, this, [this](const QPointF& point) { onClicked(point); });
  connect(view_, &MapView::dragStarted, this, [this] { ends_before_drag_px_ = ends_px_; });
  connect(view_, &MapView::dragMoved, this, &ScaleDialog::moveEnd);
  connect(view_, &MapView::dragFinished, this, &ScaleDialog::moveEnd);
  connect(view_, &MapView::dragCancelled, this, [this] {
    ends_px_ = ends_before_drag_px_;
    refresh();
  });
  connect(view_, &MapView::cancelRequested, this, [this] {
    ends_px_.clear();
    refresh();
  });

  resolution_ = new QLineEdit(this);
  resolution_->setObjectName(QStringLiteral("resolution"));
  resolution_->setPlaceholderText(tr("for example %1").arg(numberText(0.05, 2)));
  length_ = new QLineEdit(this);
  length_->setObjectName(QStringLiteral("length"));
  measured_ = new QLabel(this);
  measured_->setTextFormat(Qt::PlainText);
  extent_ = new QLabel(this);
  auto* form = new QFormLayout;
  form->addRow(tr("Line drawn:"), measured_);
  form->addRow(tr("Its &length (m):"), length_);
  form->addRow(tr("&Metres for each pixel:"), resolution_);
  form->addRow(tr("Size of the picture:"), extent_);

  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  ok_ = buttons->button(QDialogButtonBox::Ok);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(resolution_, &QLineEdit::textChanged, this, &ScaleDialog::refresh);
  connect(length_, &QLineEdit::textChanged, this, &ScaleDialog::refresh);

  auto* layout = new QVBoxLayout(this);
  layout->addWidget(text);
  layout->addWidget(view_, 1);
  layout->addLayout(form);
  layout->addWidget(buttons);
  refresh();
  resolution_->setFocus();
}

ScaleDialog::~ScaleDialog() = default;

std::optional<double> ScaleDialog::ask(QWidget* parent, const std::filesystem::path& image, Side side) {
  ScaleDialog dialog(parent, image, side);
  return dialog.exec() == QDialog::Accepted ? dialog.metresPerPixel() : std::nullopt;
}

void ScaleDialog::onClicked(const QPointF& point) {
  if (ends_px_.size() == 2) ends_px_.clear();
  ends_px_.push_back(point);
  refresh();
  if (ends_px_.size() == 2) length_->setFocus();  // after it can be typed into
}

void ScaleDialog::moveEnd(MarkerId id, const QPointF& point) {
  const auto at = static_cast<std::size_t>(id);
  if (id < 0 || at >= ends_px_.size()) return;
  ends_px_[at] = point;
  refresh();
}

std::optional<double> ScaleDialog::metresPerPixel() const {
  const auto positive = [](std::optional<double> value) { return value && *value > 0.0 ? value : std::nullopt; };
  const auto scale = [](std::optional<double> value) {
    return value && kResolutionRange.holds(*value) ? value : std::nullopt;
  };
  const std::optional<double> length_m = positive(parseNumber(length_->text()));
  if (ends_px_.size() == 2 && length_m) {
    const QPointF line = ends_px_[1] - ends_px_[0];
    const double length_px = std::hypot(line.x(), line.y());
    return length_px >= 1.0 ? scale(*length_m / length_px) : std::nullopt;
  }
  return scale(parseNumber(resolution_->text()));
}

void ScaleDialog::refresh() {
  std::vector<Marker> markers;
  for (std::size_t i = 0; i < ends_px_.size(); ++i)
    markers.push_back({static_cast<MarkerId>(i), {}, ends_px_[i], MarkerClass::kPlain, false, false});
  view_->setMarkers(std::move(markers));
  if (ends_px_.size() == 2) {
    const QPointF line = ends_px_[1] - ends_px_[0];
    view_->setPaths({PathGlyph{{ends_px_[0], ends_px_[1]}, QColor(0xc2185b), 2.5, {}, false}});
    measured_->setText(tr("%1 pixels").arg(numberText(std::hypot(line.x(), line.y()), 1)));
  } else {
    view_->setPaths({});
    measured_->setText(ends_px_.empty() ? tr("click one end") : tr("click the other end"));
  }
  length_->setEnabled(ends_px_.size() == 2);
  resolution_->setEnabled(ends_px_.size() != 2);
  const std::optional<double> scale = metresPerPixel();
  ok_->setEnabled(scale.has_value());
  view_->setScaleBarUnit(scale.value_or(0.0));
  const QSize size = picture_->size();
  extent_->setText(scale && !size.isEmpty() ? tr("%1 m x %2 m at %3 m for each pixel")
                                                  .arg(numberText(size.width() * *scale, 1))
                                                  .arg(numberText(size.height() * *scale, 1))
                                                  .arg(numberText(*scale, 5))
                                            : tr("not known yet"));
}

}  // namespace cad2slam
