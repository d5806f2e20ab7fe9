// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QTransform>
#include <QVariantAnimation>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

#include "cad2slam/map/map_frame.h"
#include "ui/views/marker.h"
#include "ui/views/marker_painter.h"
#include "ui/views/mesh_layer.h"
#include "ui/views/paint_turn.h"
#include "ui/views/preview_legend.h"
#include "ui/views/raster_layer.h"
#include "ui/views/raster_source.h"
#include "ui/views/view_state.h"

namespace cad2slam {

/// Shows one raster with its metric frame and everything that lies on it; turns mouse and keys into signals. Values in,
/// signals out: it keeps no state of the document, so whoever listens decides what a click or a drag means.
///
/// All points are metres in the frame given to setFrame() (x right, y up). One mode only: the wheel zooms at the
/// cursor; dragging an empty place, the middle button or Space + drag pans; a press that moves less than 4 logical
/// pixels is a click; a press within 12 pixels of a marker selects it, moving on drags it.
class MapView : public QWidget {
  Q_OBJECT

 public:
  explicit MapView(QWidget* parent = nullptr);
  ~MapView() override;

  // --- what is shown -----------------------------------------------------------------------------------------------
  /// The raster; null shows the empty text, and clicks place nothing.
  void setImage(std::shared_ptr<RasterSource> image);
  /// The metric frame of the raster. The view state is kept: call fit() for a new raster.
  void setFrame(const MapFrame& frame);
  /// Another metric frame for the raster that is shown: the view goes on showing the same part of it.
  void reframe(const MapFrame& frame);
  [[nodiscard]] const std::optional<MapFrame>& frame() const;
  /// Shown in the drop zone while there is no image.
  void setEmptyText(const QString& text);
  /// Metres for each unit of the frame, for the scale bar; 0 where that is not known, and there is no bar then.
  void setScaleBarUnit(double metres);
  void setMagnificationNote(bool shown);

  void setMarkers(std::vector<Marker> markers);
  void setMarkersVisible(bool visible);
  void setMarkerTextVisible(bool visible);
  /// Where markers crowd they become dots without text, so that the map can be seen.
  void setMapFirst(bool on);
  /// Markers are dots without text however few there are, and residuals lie over them.
  void setMarkersAsDots(bool on);
  void setGhost(std::optional<Ghost> ghost);
  /// A note tells a magnification other than 1, unless setMagnificationNote(false).
  void setResiduals(std::vector<ResidualVector> residuals, double magnification);
  /// 1, 2 or 5 times a power of ten, and with it the longest residual is about a tenth of the view; never below 1.
  static constexpr double kAutomaticMagnification = 0.0;
  /// The factor that is drawn with.
  [[nodiscard]] double residualMagnification() const;
  /// Shared with whoever made it; null takes it away.
  void setMesh(std::shared_ptr<const MeshOverlay> mesh);
  void setPoses(std::vector<PoseGlyph> poses);
  void setPaths(std::vector<PathGlyph> paths);
  /// The place under the cursor of the other view; `certain` is false where it is extrapolated.
  void setMirroredCursor(std::optional<QPointF> point_m, bool certain = true);
  /// Enlarges a marker as if it were under the cursor: the other view's hoveredMarkerChanged().
  void setHighlighted(MarkerId id);
  /// A text in a chip at the top; with `framed` the view also gets the frame that says "your turn". Empty takes it
  /// away.
  void setAttention(const QString& chip_text, bool framed);

  // --- how it reacts -----------------------------------------------------------------------------------------------
  void setLocked(bool locked);  ///< markers can be selected, not dragged or nudged
  void setSnapping(bool on);    ///< suspended while Alt is held
  [[nodiscard]] bool isSnapping() const;
  void setCrosshair(bool on);  ///< over the full view; always on while the loupe is
  void setLoupe(bool on);      ///< kept on; holding Z shows it for as long
  [[nodiscard]] bool isLoupeOn() const;
  void setLoupeHeld(bool held);  ///< the other view's loupeHeld()
  [[nodiscard]] bool isDragging() const;

  // --- what part is shown ------------------------------------------------------------------------------------------
  [[nodiscard]] ViewState viewState() const;
  void setViewState(const ViewState& state);
  void fit();                                              ///< the whole raster
  [[nodiscard]] bool isFitted() const { return fitted_; }  ///< and the view was not moved since
  void fitRect(const QRectF& area_m, double margin = 0.1);
  void showActualSize();       ///< one image pixel for each device pixel
  void zoomBy(double factor);  ///< at the centre; > 1 enlarges
  void setRotation(double rotation_rad);
  /// Keeps zoom and rotation.
  void centerOn(const QPointF& point_m, bool animated);
  void clickInMiddle();  ///< clicked() there, for those who move the view by keys
  [[nodiscard]] bool isInView(const QPointF& point_m, double margin_px = 24.0) const;

  [[nodiscard]] QPointF metresFromWidget(const QPointF& widget_px) const;
  [[nodiscard]] QPointF widgetFromMetres(const QPointF& point_m) const;
  /// Column and row in the raster, continuous, from metres.
  [[nodiscard]] QPointF imagePixelFromMetres(const QPointF& point_m) const;

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 signals:
  /// Click or Enter in the empty drop zone.
  void chooseRequested();
  /// A click on no marker. `snapped`: the point is the corner that was shown before the click.
  void clicked(const QPointF& point_m, Qt::KeyboardModifiers modifiers, bool snapped);
  /// A press on a marker or pose, before any drag; Ctrl and Shift are for multi-selection.
  void markerPressed(cad2slam::MarkerId id, Qt::KeyboardModifiers modifiers);
  /// Pressed and let go there: neither dragged nor, while locked, panned.
  void markerClicked(cad2slam::MarkerId id, Qt::KeyboardModifiers modifiers);
  void markerDoubleClicked(cad2slam::MarkerId id);
  void markerMenuRequested(cad2slam::MarkerId id, const QPoint& global_px);
  /// Right click on no marker.
  void menuRequested(const QPointF& point_m, const QPoint& global_px);

  void dragStarted(cad2slam::MarkerId id);
  void dragMoved(cad2slam::MarkerId id, const QPointF& point_m);
  void dragFinished(cad2slam::MarkerId id, const QPointF& point_m, bool snapped);
  void dragCancelled(cad2slam::MarkerId id);
  /// As dragMoved / dragFinished, for the heading of a turnable pose; framed by dragStarted and dragCancelled as well.
  void poseTurned(cad2slam::MarkerId id, double heading_rad);
  void poseTurnFinished(cad2slam::MarkerId id, double heading_rad);

  void hoveredMarkerChanged(cad2slam::MarkerId id);
  /// Arrow keys: 1 image pixel in the direction seen on screen, Shift 10, Ctrl 0.1. Nudges that follow each other
  /// within a second share a burst number.
  void nudged(const QPointF& delta_m, int burst);
  void acceptRequested();  ///< Enter
  void cancelRequested();  ///< Esc with nothing to restore in the view
  void deleteRequested();  ///< Del or Backspace

  /// Pixel and metre read-out; also feeds the mirrored cursor of the other view.
  void cursorMoved(const QPointF& point_m, const QPointF& image_px);
  void cursorLeft();
  void viewStateChanged();
  void loupeChanged(bool on);
  void loupeHeld(bool held);  ///< Z went down or up here: the other view may show its loupe as well
  void filesDropped(const QStringList& paths);

 protected:
  /// The raster itself; a subclass may draw something else in its place, logical pixels.
  virtual void paintBase(QPainter& painter);
  /// Over everything else but the loupe.
  virtual void paintOnTop(QPainter& painter);
  /// What colours mean, shown in the lower right corner; gives way to the pointer.
  [[nodiscard]] virtual std::optional<PreviewLegend> legend() const;
  [[nodiscard]] double meshFullColor() const { return mesh_full_color_; }
  [[nodiscard]] RasterLayer& raster() { return raster_; }
  [[nodiscard]] QTransform widgetFromImage() const;
  [[nodiscard]] QColor backgroundColor() const;

  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  bool event(QEvent* event) override;

 private:
  enum class Gesture {
    kNone,
    kPressed,  ///< left button down, not moved yet
    kPan,
    kDragMarker,
    kTurnPose,
    kTurnView,
    kSpent,  ///< cancelled with Esc; waits for the release
  };
  /// Logical pixels.
  struct SeenMarker {
    const Marker* marker;
    QPointF at;
    MarkerSize size;
    bool in_front;  // of all others, and never without its text
  };
  struct Hit {
    MarkerId id = kNoMarker;
    QPointF point_m;
    bool is_pose = false;
    bool on_handle = false;
  };

  void paintOverlays(QPainter& painter, const QTransform& widget_from_metres, double px_per_m);
  /// `to_drag`: those that can be dragged, or else the others.
  void paintPoses(QPainter& painter, const QTransform& widget_from_metres, double px_per_m, bool to_drag);
  [[nodiscard]] std::vector<SeenMarker> seenMarkers(const QTransform& widget_from_metres) const;
  void paintMarkers(QPainter& painter, const QTransform& widget_from_metres);
  /// `over_markers`: those that a marker would hide, or else the others.
  void paintResiduals(QPainter& painter, const QTransform& widget_from_metres, bool over_markers);
  void paintLoupe(QPainter& painter);
  void paintLegend(QPainter& painter);
  void moveCursor(const QPointF& widget_px);
  void updateTransform();
  void changeState(const ViewState& state);
  void zoomAt(const QPointF& widget_px, double factor);
  void rotateAt(const QPointF& widget_px, double angle_rad);
  [[nodiscard]] double clampedResolution(double m_per_px) const;

  [[nodiscard]] std::optional<Hit> hitAt(const QPointF& widget_px) const;
  [[nodiscard]] const Marker* selectedMarker() const;
  void beginDrag();
  void moveDrag(Qt::KeyboardModifiers modifiers);
  void cancelDrag();
  void endGesture(Qt::KeyboardModifiers modifiers);  // as its button goes up
  void showHover(Qt::KeyboardModifiers modifiers);
  void findSnap(const QPointF& widget_px, Qt::KeyboardModifiers modifiers);
  void showCursorShape();
  void showLoupeWhileHeld(bool held);
  void panByKey(const QPointF& direction, bool fine);
  bool nudge(int key, Qt::KeyboardModifiers modifiers);
  void stopAnimation();

  // What is shown.
  RasterLayer raster_;
  RasterLayer loupe_raster_;
  MeshLayer mesh_;
  double mesh_full_color_ = kUsualStrain;
  MarkerPainter marker_painter_;
  PaintTurn paint_turn_{*this};
  std::optional<MapFrame> frame_;
  QMetaObject::Connection image_connection_;
  QElapsedTimer image_since_;
  QString empty_text_;
  std::vector<Marker> markers_;
  bool markers_visible_ = true;
  bool marker_text_visible_ = true;
  bool map_first_ = false;
  bool dots_ = false;
  std::optional<Ghost> ghost_;
  std::vector<ResidualVector> residuals_;
  double residual_magnification_ = 1.0;
  bool magnification_note_ = true;
  std::vector<PoseGlyph> poses_;
  std::vector<PathGlyph> paths_;
  std::optional<QPointF> mirrored_cursor_m_;
  bool mirrored_certain_ = true;
  MarkerId highlighted_ = kNoMarker;
  QString chip_text_;
  bool framed_ = false;
  QRectF legend_rect_;

  // How.
  ViewState state_;
  QTransform widget_from_metres_;
  QTransform metres_from_widget_;
  bool fitted_ = false;      // and not moved since
  QPoint origin_in_window_;  // as of the last resize
  QSize window_size_;
  double scale_bar_unit_m_ = 1.0;
  QVariantAnimation animation_;
  bool locked_ = false;
  bool snapping_ = true;
  bool crosshair_ = false;
  bool moved_by_keys_ = false;  // since the mouse last moved: the middle is where clickInMiddle() clicks
  bool loupe_on_ = false;
  bool loupe_held_ = false;
  bool drop_hover_ = false;

  // Where the mouse is and what it does.
  Gesture gesture_ = Gesture::kNone;
  Qt::MouseButton gesture_button_ = Qt::NoButton;
  std::optional<QPointF> cursor_;  // logical pixels, while over the view
  QPointF press_;
  QPointF last_;
  std::optional<Hit> pressed_;
  QPointF grab_offset_;  // from the cursor to the place of what is dragged
  QPointF drag_point_m_;
  double drag_heading_ = 0.0;
  bool drag_snapped_ = false;
  MarkerId hovered_ = kNoMarker;
  bool compass_hovered_ = false;
  bool space_held_ = false;
  bool long_pressed_ = false;
  std::optional<QPointF> snap_m_;
  QTimer long_press_;
  QElapsedTimer last_nudge_;
  int burst_ = 0;
};

}  // namespace cad2slam
