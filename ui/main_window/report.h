// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/core/result.h"
#include "ui/main_window/session.h"

#include <QImage>
#include <QString>
#include <QStringList>

#include <memory>
#include <vector>

class QTextDocument;

class QPainter;

namespace cad2slam {

struct ReportPicture {
  QString caption;
  QImage image;
};

/// What a report shows beyond the session itself.
struct ReportExtras {
  std::vector<ReportPicture> pictures;
  QStringList findings;  ///< sentences of the diagnosis
};

/// Both maps in two inks, the whole blueprint, whatever the preview shows. Null while there is no alignment.
[[nodiscard]] QImage picturesOverEachOther(Session& session);
/// The report as HTML; pictures are named picture0, picture1, ...
[[nodiscard]] QString reportHtml(Session& session, const ReportExtras& extras);
/// The same, laid out on pages.
[[nodiscard]] std::unique_ptr<QTextDocument> reportDocument(Session& session, const ReportExtras& extras);
/// One page of it, from the top left corner on, in pixels of the document.
void drawReportPage(QPainter& painter, const QTextDocument& text, int page);
/// Writes it as PDF on A4, atomically.
[[nodiscard]] Result<void> writeReport(const QString& path, Session& session, const ReportExtras& extras);

}  // namespace cad2slam
