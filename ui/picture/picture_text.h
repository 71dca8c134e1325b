// Texts about editing pictures of maps.
#pragma once

#include <QColor>
#include <QDateTime>
#include <QString>

#include "robot/picture_store.h"
#include "ui/picture/picture_tool.h"

namespace mapwright::window {

QString modeName(PaintMode mode);
QString modeTip(PaintMode mode);
QString modeIcon(PaintMode mode);
QString kindName(picture::Kind kind);
QString kindTip(picture::Kind kind);
QString tidyName(Tidying what);
QString tidyTip(Tidying what);
/// "12 specks, 48 cells would change."
QString previewText(const TidyPreview& preview);
/// "becomes free: 12 cells"
QString becomesText(picture::Kind kind, std::int64_t cells);
/// How to mark a cell that would become this kind: distinguishable by lightness and hatching, not only by
/// colour.
struct BecomesLook {
  QColor color;
  Qt::BrushStyle lines;  // over the colour, if there is room
};
BecomesLook becomesLook(picture::Kind kind);
/// "1,204 cells are changed." "Nothing is changed."
QString changedText(std::int64_t cells);
QString cellsText(std::int64_t cells);
QString draftText(const QDateTime& made, const QDateTime& now, std::int64_t cells);
QString conflictText(std::int64_t cells);
QString obstacleText(robot::PictureObstacle obstacle);
QString cellBetweenText(int percent);

}  // namespace mapwright::window
