#include "ui/picture/picture_text.h"

#include <QCoreApplication>
#include <QLocale>

#include "sentences/plural.h"

namespace mapwright::window {
namespace {

struct PictureModeText {
  Q_DECLARE_TR_FUNCTIONS(mapwright::window::Picture)
};

}  // namespace

QString modeName(PaintMode mode) {
  switch (mode) {
    case PaintMode::Brush:
      return PictureModeText::tr("Brush");
    case PaintMode::Eraser:
      return PictureModeText::tr("Eraser");
    case PaintMode::Line:
      return PictureModeText::tr("Line");
    case PaintMode::Rectangle:
      return PictureModeText::tr("Rectangle");
    case PaintMode::Polygon:
      return PictureModeText::tr("Polygon");
    case PaintMode::Fill:
      return PictureModeText::tr("Fill");
    case PaintMode::Select:
      return PictureModeText::tr("Select");
  }
  return {};
}

QString modeTip(PaintMode mode) {
  switch (mode) {
    case PaintMode::Brush:
      return PictureModeText::tr("Brush: paint freehand");
    case PaintMode::Eraser:
      return PictureModeText::tr("Eraser: restore the saved map where you paint");
    case PaintMode::Line:
      return PictureModeText::tr("Line: a straight wall, as wide as the brush");
    case PaintMode::Rectangle:
      return PictureModeText::tr("Rectangle: filled");
    case PaintMode::Polygon:
      return PictureModeText::tr("Polygon: filled, corner by corner");
    case PaintMode::Fill:
      return PictureModeText::tr("Fill: a connected area of the same kind");
    case PaintMode::Select:
      return PictureModeText::tr("Select: a part to copy, move, paint or clean up");
  }
  return {};
}

QString modeIcon(PaintMode mode) {
  switch (mode) {
    case PaintMode::Brush:
      return QStringLiteral("brush");
    case PaintMode::Eraser:
      return QStringLiteral("eraser");
    case PaintMode::Line:
      return QStringLiteral("line");
    case PaintMode::Rectangle:
      return QStringLiteral("rectangle");
    case PaintMode::Polygon:
      return QStringLiteral("polygon");
    case PaintMode::Fill:
      return QStringLiteral("fill");
    case PaintMode::Select:
      break;
  }
  return QStringLiteral("select");
}

QString kindName(picture::Kind kind) {
  switch (kind) {
    case picture::Kind::Free:
      return PictureModeText::tr("Free");
    case picture::Kind::Occupied:
      return PictureModeText::tr("Occupied");
    case picture::Kind::Unknown:
      break;
  }
  return PictureModeText::tr("Unknown");
}

QString kindTip(picture::Kind kind) {
  switch (kind) {
    case picture::Kind::Free:
      return PictureModeText::tr("Free: where robots may drive");
    case picture::Kind::Occupied:
      return PictureModeText::tr("Occupied: walls and other obstacles");
    case picture::Kind::Unknown:
      break;
  }
  return PictureModeText::tr("Unknown: not observed yet");
}

QString tidyName(Tidying what) {
  switch (what) {
    case Tidying::Specks:
      return PictureModeText::tr("Specks up to");
    case Tidying::Gaps:
      return PictureModeText::tr("Gaps in walls up to");
    case Tidying::Edges:
      break;
  }
  return PictureModeText::tr("Ragged edges up to");
}

QString tidyTip(Tidying what) {
  switch (what) {
    case Tidying::Specks:
      return PictureModeText::tr(
          "Removes groups of at most this many occupied cells: they become like their surroundings");
    case Tidying::Gaps:
      return PictureModeText::tr("Closes gaps of at most this many cells between occupied cells");
    case Tidying::Edges:
      break;
  }
  return PictureModeText::tr(
      "Smooths spikes and notches of at most this width between free and unknown areas");
}

QString cellsText(std::int64_t cells) {
  return sentences::counted(PictureModeText::tr("%1 cells", nullptr, sentences::formOf(cells)), cells);
}

QString previewText(const TidyPreview& preview) {
  if (preview.step.patch.empty()) return PictureModeText::tr("There is nothing to clean up.");
  if (preview.what != Tidying::Specks)
    return PictureModeText::tr("%1 would change.").arg(cellsText(preview.found.cells));
  const QString specks =
      sentences::counted(PictureModeText::tr("%1 specks", nullptr, sentences::formOf(preview.found.pieces)),
                         preview.found.pieces);
  return PictureModeText::tr("%1 of %2 would be removed.").arg(specks, cellsText(preview.found.cells));
}

QString becomesText(picture::Kind kind, std::int64_t cells) {
  switch (kind) {
    case picture::Kind::Free:
      return PictureModeText::tr("becomes free: %1").arg(cellsText(cells));
    case picture::Kind::Occupied:
      return PictureModeText::tr("becomes occupied: %1").arg(cellsText(cells));
    case picture::Kind::Unknown:
      break;
  }
  return PictureModeText::tr("becomes unknown: %1").arg(cellsText(cells));
}

BecomesLook becomesLook(picture::Kind kind) {
  switch (kind) {
    case picture::Kind::Free:
      return {QColor(86, 180, 233), Qt::NoBrush};
    case picture::Kind::Occupied:
      return {QColor(213, 94, 0), Qt::FDiagPattern};
    case picture::Kind::Unknown:
      break;
  }
  return {QColor(170, 51, 119), Qt::DiagCrossPattern};
}

QString changedText(std::int64_t cells) {
  if (cells == 0) return PictureModeText::tr("Nothing was changed.");
  return PictureModeText::tr("Changed: %1.").arg(cellsText(cells));
}

QString draftText(const QDateTime& made, const QDateTime& now, std::int64_t cells) {
  const QLocale c = QLocale::c();
  const QString when = made.date() == now.date()
                           ? PictureModeText::tr("today %1").arg(c.toString(made, QStringLiteral("HH:mm:ss")))
                           : c.toString(made, QStringLiteral("d MMMM yyyy HH:mm"));
  return PictureModeText::tr("There is an unsaved draft of this map from %1: %2.")
      .arg(when, cellsText(cells));
}

QString conflictText(std::int64_t cells) {
  return PictureModeText::tr("Changed differently here and elsewhere: %1. Which version do you want to keep?")
      .arg(cellsText(cells));
}

QString obstacleText(robot::PictureObstacle obstacle) {
  switch (obstacle) {
    case robot::PictureObstacle::NotStored:
      return PictureModeText::tr("Only stored maps can be edited, not the live one.");
    case robot::PictureObstacle::FormatNotWritten:
      break;
  }
  return PictureModeText::tr(
      "Pictures of this format are read-only. Export the map as PGM and YAML and edit that.");
}

QString cellBetweenText(int percent) {
  return PictureModeText::tr(
             "Some cells of this map are neither free, occupied nor unknown but in between (%1 of 100), and "
             "the robot's map manager has no gray level for these, so the map could not be sent back. Export "
             "the map to edit it as files.")
      .arg(percent);
}

}  // namespace mapwright::window
