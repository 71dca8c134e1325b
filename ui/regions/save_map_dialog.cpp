#include "ui/regions/save_map_dialog.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/kit/dialog_look.h"

namespace mapwright::window {
namespace {

constexpr int kLongestFilename = 200, kWidthPx = 420;

}  // namespace

SaveMapDialog::SaveMapDialog(QWidget* parent)
    : QDialog(parent), name_(new QLineEdit(this)), state_(new QLabel(this)) {
  setWindowTitle(tr("Save the map on the robot"));
  setAttribute(Qt::WA_DeleteOnClose);
  setMinimumWidth(kWidthPx);
  name_->setObjectName(QStringLiteral("saveMapName"));
  name_->setMaxLength(kLongestFilename);
  name_->setText(QStringLiteral("map.png"));
  name_->setSelection(0, 3);
  auto* const about = new QLabel(tr("The robot writes its map to a file on its own disk. The extension of "
                                    "the name selects the format: most know .png, .pgm or .yaml for grids "
                                    "and .pcd, .ply or .vtk for clouds. An existing file may be replaced."),
                                 this);
  about->setTextFormat(Qt::PlainText);
  about->setWordWrap(true);
  state_->setTextFormat(Qt::PlainText);
  state_->setObjectName(QStringLiteral("saveMapState"));
  state_->setWordWrap(true);
  state_->hide();
  auto* const form = new QFormLayout;
  form->addRow(tr("&Name on the robot"), name_);
  save_ = new QPushButton(tr("Save"), this);
  auto* const cancel = new QPushButton(tr("Cancel"), this);
  giveRoles(*save_, {cancel});
  auto* const buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  buttons->addStretch();
  buttons->addWidget(cancel);
  buttons->addWidget(save_);
  auto* const column = new QVBoxLayout(this);
  column->setSpacing(12);
  column->addLayout(form);
  column->addWidget(about);
  column->addWidget(state_);
  column->addStretch();
  column->addLayout(buttons);
  // Wrapped text needs less height than requested before the width is known.
  resize(kWidthPx, column->totalHeightForWidth(kWidthPx));
  connect(name_, &QLineEdit::textChanged, this, &SaveMapDialog::look);
  connect(save_, &QPushButton::clicked, this, [this] { Q_EMIT saveWanted(filename()); });
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  look();
}

QString SaveMapDialog::filename() const { return name_->text().trimmed(); }

void SaveMapDialog::look() { save_->setEnabled(!waits_ && !filename().isEmpty()); }

void SaveMapDialog::wait() {
  waits_ = true;
  name_->setEnabled(false);
  state_->setText(tr("Waiting for the robot…"));
  state_->show();
  look();
}

void SaveMapDialog::refuse(const QString& why) {
  waits_ = false;
  name_->setEnabled(true);
  state_->setText(why);
  state_->show();
  look();
}

}  // namespace mapwright::window

#include "moc_save_map_dialog.cpp"
