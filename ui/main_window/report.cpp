// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/report.h"

#include "cad2slam/io/atomic_file.h"
#include "ui/convert.h"
#include "ui/main_window/preview_wiring.h"
#include "ui/models/number_text.h"
#include "ui/services/preview_renderer.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>

#include <algorithm>

namespace cad2slam {
namespace {

constexpr int kDotsPerInch = 150;
constexpr int kMarginMm = 14;
// All below at 96 dots per inch, and the text in pixels: on every screen the pages are the same.
constexpr int kPageWidth = 688;  // of A4 between the margins
constexpr int kFooterHeight = 26;
constexpr int kFooterText_px = 11;
constexpr int kPageHeight = 1016 - kFooterHeight;
constexpr int kHeadingHeight = 60;
constexpr int kPictureWidth = 670;

struct Text {
  Q_DECLARE_TR_FUNCTIONS(Report)
};

QString row(const QStringList& cells, const char* tag = "td") {
  QString html = QStringLiteral("<tr>");
  for (const QString& cell : cells)
    html += QStringLiteral("<%1 align=\"left\">%2</%1>").arg(QLatin1String(tag), cell.toHtmlEscaped());
  return html + QStringLiteral("</tr>");
}

/// For numbers: a row of more than one line could be cut by the end of a page.
QString inOneLine(QString text) {
  return text.replace(QLatin1Char(' '), QChar(QChar::Nbsp));
}

QString length(const std::optional<double>& value_m) {
  return value_m ? inOneLine(lengthText(*value_m)) : QStringLiteral("–");
}

QString wordOf(AnchorClass judged) {
  switch (judged) {
    case AnchorClass::kOk:
      return Text::tr("OK");
    case AnchorClass::kLook:
      return Text::tr("look");
    case AnchorClass::kBad:
      return Text::tr("bad");
    case AnchorClass::kDisabled:
      return Text::tr("off (check)");
    case AnchorClass::kPlain:
      return {};
  }
  return {};
}

QString rasterRow(const QString& name, const ProjectRaster& raster, const std::optional<MapFrame>& frame) {
  const QString size = frame ? QStringLiteral("%1 x %2 px").arg(frame->width()).arg(frame->height()) : QString();
  return row({name, toQString(raster.metadata.image.filename()), size,
              Text::tr("%1 m/px").arg(numberText(raster.metadata.resolution_m_per_px, 4)),
              toQString(raster.image_sha256).left(16)});
}

}  // namespace

QImage picturesOverEachOther(Session& session) {
  constexpr int kLongSide_px = 1500;
  const SolveResultPtr& result = session.alignment().result();
  if (!result || !session.isReady()) return {};
  const RasterStore& rasters = session.rasters();
  const MapFrame& frame = *rasters.frame(Side::kBlueprint);
  auto scene = std::make_shared<PreviewScene>();
  scene->base = previewRaster(rasters, Side::kBlueprint);
  scene->base_ink = kBlueprintInk;
  scene->layers.push_back({previewRaster(rasters, Side::kSlam), result->projector, kSlamInk});

  PreviewRequest request;
  request.scene = std::move(scene);
  request.kind = PreviewKind::kInks;
  request.size = QSize(frame.width(), frame.height()).scaled(kLongSide_px, kLongSide_px, Qt::KeepAspectRatio);
  request.size = request.size.expandedTo(QSize(1, 1));
  request.state.center_m = toQPointF(frame.metricFromPixel({frame.width() / 2.0, frame.height() / 2.0}));
  request.state.m_per_px = frame.resolution() * frame.width() / request.size.width();
  request.state.rotation_rad = -frame.metricFromCorner().heading;
  const Result<PreviewPicture> picture = renderPreview(request);
  return picture ? picture->image : QImage();
}

QString reportHtml(Session& session, const ReportExtras& extras) {
  ProjectDocument& document = session.document();
  const AlignmentSummary& summary = session.summary();
  QString html = QStringLiteral("<html><body style=\"font-family: sans-serif; font-size: 12px\">");
  const QString title = document.path().empty() ? Text::tr("Project not saved") : toQString(document.path().filename());
  html +=
      QStringLiteral("<h1>%1</h1><p>%2</p>")
          .arg(title.toHtmlEscaped(), Text::tr("CAD2SLAM %1, %2")
                                          .arg(QCoreApplication::applicationVersion(),
                                               QLocale().toString(QDateTime::currentDateTime(), QLocale::ShortFormat))
                                          .toHtmlEscaped());

  const auto caution = [&](const QString& sentence) {
    html += QStringLiteral("<p><b>▲ %1</b></p>").arg(sentence.toHtmlEscaped());
  };
  if (document.isModified()) caution(Text::tr("The project has changes that are not saved in its file."));
  if (session.alignment().result() && !session.alignment().isCurrent())
    caution(Text::tr("The figures below are those of an earlier state: the project as it is was not solved."));
  html += QStringLiteral("<h2>%1</h2><table cellpadding=\"3\" width=\"100%\">").arg(Text::tr("Result"));
  html += row({Text::tr("Anchors used"), Text::tr("%1 of %2").arg(summary.used).arg(summary.total)});
  html += row({Text::tr("RMS of the residuals"), length(summary.rms_residual_m)});
  html += row({Text::tr("Largest residual"), length(summary.max_residual_m)});
  html += row({Text::tr("Median error without the anchor itself"), length(summary.median_leave_one_out_m)});
  if (const SolveResultPtr& result = session.alignment().result()) {
    const Similarity2& fit = result->solution.global_fit;
    html +=
        row({Text::tr("Turn and scale of the SLAM map"),
             Text::tr("%1°, %2").arg(numberText(wrapAngle(fit.heading) * 180.0 / kPi, 2), numberText(fit.scale, 4))});
    html += row({Text::tr("Mesh"), Text::tr("%1 nodes, cells of %2 m, folded tiles: %3")
                                       .arg(result->mesh->nodeCount())
                                       .arg(numberText(result->mesh->lattice().cell_size, 2))
                                       .arg(result->projector.foldedTileCount())});
  }
  html += QStringLiteral("</table>");

  if (!extras.findings.isEmpty()) {
    html += QStringLiteral("<h2>%1</h2><ul>").arg(Text::tr("To look at"));
    for (const QString& finding : extras.findings) html += QStringLiteral("<li>%1</li>").arg(finding.toHtmlEscaped());
    html += QStringLiteral("</ul>");
  }
  int free_height = 0;  // below the preview, which follows what is above: the next picture begins a page
  for (std::size_t i = 0; i < extras.pictures.size(); ++i) {
    // Without a height, room is left for the picture in its full size.
    const QSize size =
        extras.pictures[i].image.size().scaled(kPictureWidth, kPageHeight - kHeadingHeight, Qt::KeepAspectRatio);
    const int height = size.height();
    const bool new_page = i > 0 && height + kHeadingHeight > free_height;
    html += QStringLiteral("<h2%1>%2</h2><p><img src=\"picture%3\" width=\"%4\" height=\"%5\"></p>")
                .arg(new_page ? QStringLiteral(" style=\"page-break-before: always\"") : QString(),
                     extras.pictures[i].caption.toHtmlEscaped())
                .arg(i)
                .arg(size.width())
                .arg(height);
    if (i > 0) free_height = (new_page ? kPageHeight : free_height) - height - kHeadingHeight;
  }

  html += QStringLiteral("<h2>%1</h2><table cellpadding=\"2\" width=\"100%\">").arg(Text::tr("Anchors"));
  html += QStringLiteral("<thead>");  // again on every page
  html += row({Text::tr("#"), Text::tr("Name"), Text::tr("Blueprint x, y (m)"), Text::tr("SLAM map x, y (m)"),
               Text::tr("Residual"), Text::tr("Without it"), Text::tr("Verdict"), Text::tr("Note")},
              "th") +
          QStringLiteral("</thead>");
  const auto place = [](const Eigen::Vector2d& point) {
    return inOneLine(metresText(point.x()) + QStringLiteral("; ") + metresText(point.y()));
  };
  for (const Anchor& anchor : document.anchors()) {
    const auto found = session.judgements().find(anchor.id);
    const AnchorJudgement judgement = found == session.judgements().end() ? AnchorJudgement{} : found->second;
    html += row({QString::number(anchor.id), toQString(anchor.name), place(anchor.in_blueprint), place(anchor.in_slam),
                 length(judgement.residual_m), length(judgement.leave_one_out_m), wordOf(judgement.judged),
                 toQString(anchor.note)});
  }
  html += QStringLiteral("</table><h2>%1</h2><table cellpadding=\"2\" width=\"100%\">").arg(Text::tr("Images"));
  html += row({QString(), Text::tr("File"), Text::tr("Size"), Text::tr("Resolution"), Text::tr("SHA-256 (first 16)")},
              "th");
  html += rasterRow(Text::tr("Blueprint"), document.project().blueprint, session.rasters().frame(Side::kBlueprint));
  if (const ProjectSlamMap* map = document.currentMap())
    html += rasterRow(Text::tr("SLAM map"), map->raster, session.rasters().frame(Side::kSlam));
  return html + QStringLiteral("</table></body></html>");
}

std::unique_ptr<QTextDocument> reportDocument(Session& session, const ReportExtras& extras) {
  auto text = std::make_unique<QTextDocument>();
  for (std::size_t i = 0; i < extras.pictures.size(); ++i)
    text->addResource(QTextDocument::ImageResource, QUrl(QStringLiteral("picture%1").arg(i)), extras.pictures[i].image);
  text->setHtml(reportHtml(session, extras));
  text->setPageSize(QSizeF(kPageWidth, kPageHeight));
  return text;
}

void drawReportPage(QPainter& painter, const QTextDocument& text, int page) {
  // Not drawContents(), which writes in the colour of the theme: white in the dark one.
  QAbstractTextDocumentLayout::PaintContext context;
  context.clip = QRectF(0, page * kPageHeight, kPageWidth, kPageHeight);
  context.palette.setColor(QPalette::Text, Qt::black);
  painter.translate(0, -page * kPageHeight);
  painter.setClipRect(context.clip);
  text.documentLayout()->draw(&painter, context);
}

Result<void> writeReport(const QString& path, Session& session, const ReportExtras& extras) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(kMarginMm, kMarginMm, kMarginMm, kMarginMm), QPageLayout::Millimeter);
    writer.setResolution(kDotsPerInch);
    writer.setTitle(Text::tr("CAD2SLAM report"));
    // Not QTextDocument::print(), which puts margins of its own inside those of the page.
    const std::unique_ptr<QTextDocument> text = reportDocument(session, extras);
    QPainter painter(&writer);
    const double scale = static_cast<double>(writer.width()) / kPageWidth;
    painter.scale(scale, scale);
    QFont small = painter.font();
    small.setPixelSize(kFooterText_px);
    const int pages = text->pageCount();
    for (int page = 0; page < pages; ++page) {
      if (page > 0) writer.newPage();
      painter.save();
      drawReportPage(painter, *text, page);
      painter.restore();
      painter.setFont(small);
      painter.drawText(QRect(0, kPageHeight, kPageWidth, kFooterHeight), Qt::AlignRight | Qt::AlignBottom,
                       Text::tr("Page %1 of %2").arg(page + 1).arg(pages));
    }
  }
  return writeFileAtomically(toPath(path), buffer.data().toStdString());
}

}  // namespace cad2slam
