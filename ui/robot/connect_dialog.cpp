#include "ui/robot/connect_dialog.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QToolButton>

#include "robot/address.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/ui_colors.h"
#include "words/qt_plain.h"

namespace mapwright::window {

namespace {

/// What may be typed: just a host, or an address of each kind.
QString examplesText(const QStringList& examples) {
  const QString host = ConnectDialog::tr("For example 192.0.2.7 or robot.local:8090.");
  if (examples.isEmpty()) return host;
  return host + QLatin1Char(' ') +
         ConnectDialog::tr("A full address looks like %1.").arg(examples.join(QStringLiteral(", ")));
}

}  // namespace

ConnectDialog::ConnectDialog(RecentRobots& recents, Attempt attempt, QWidget* parent)
    : QDialog(parent),
      recents_(recents),
      attempt_(std::move(attempt)),
      address_(new QLineEdit(this)),
      secret_(new QLineEdit(this)),
      error_(wrappedLabel({}, this)),
      list_(new QListWidget(this)),
      connect_(new QPushButton(tr("Connect"), this)) {
  setWindowTitle(tr("Connect to a robot"));
  setMinimumWidth(580);
  auto* demo = new QPushButton(themedIcon(QStringLiteral("demo")), tr("Try the demo robot"), this);
  demo->setObjectName(QStringLiteral("secondary"));
  demo->setAutoDefault(false);
  auto* cancel = new QPushButton(tr("Cancel"), this);
  cancel->setObjectName(QStringLiteral("secondary"));
  cancel->setAutoDefault(false);
  connect_->setObjectName(QStringLiteral("primary"));
  connect_->setDefault(true);
  setLayout(
      columnOf({buildForm(), {buildRecents(), 1}, rowOf({demo, LayoutItem::rest(), cancel, connect_}, 8)}, 12,
               QMargins(16, 16, 16, 16)));

  connect(address_, &QLineEdit::textChanged, this, &ConnectDialog::check);
  connect(secret_, &QLineEdit::textEdited, this, &ConnectDialog::check);
  connect(connect_, &QPushButton::clicked, this,
          [this] { start(address_->text().trimmed(), secret_->text().toUtf8()); });
  connect(demo, &QPushButton::clicked, this, [this] { start(QStringLiteral("demo:"), {}); });
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  fillRecents();
  check();
  address_->setFocus();
}

QWidget* ConnectDialog::buildForm() {
  auto* form_box = new QWidget(this);
  auto* form = new QFormLayout(form_box);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(4);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  address_->setObjectName(QStringLiteral("address"));
  address_->setPlaceholderText(QStringLiteral("192.0.2.7"));
  auto* examples = wrappedLabel(examplesText(recents_.addresses().examples()), form_box);
  setTextColor(*examples, appColors().secondary_text);
  secret_->setObjectName(QStringLiteral("secret"));
  secret_->setEchoMode(QLineEdit::Password);
  secret_->setPlaceholderText(tr("Only if the robot asks for one"));
  auto* note =
      wrappedLabel(tr("Used for this connection only. This version never stores secrets."), form_box);
  setTextColor(*note, appColors().secondary_text);
  error_->setObjectName(QStringLiteral("error"));
  setTextColor(*error_, appColors().error_text);
  error_->hide();
  form->addRow(tr("&Address"), address_);
  form->addRow(QString(), error_);
  form->addRow(QString(), examples);
  form->addRow(tr("&Secret"), secret_);
  form->addRow(QString(), note);
  return form_box;
}

QWidget* ConnectDialog::buildRecents() {
  auto* box = new QWidget(this);
  list_->setObjectName(QStringLiteral("recents"));
  list_->setMinimumHeight(120);
  list_->setUniformItemSizes(true);
  list_->setAccessibleName(tr("Recent robots"));
  box->setLayout(columnOf({wrappedLabel(tr("Recent robots and files"), box), {list_, 1}}, 4, QMargins()));
  connect(list_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
    if (!item || item->data(Qt::UserRole).toString() == address_->text()) return;
    address_->setText(item->data(Qt::UserRole).toString());
    secret_->clear();  // it was typed for another robot
  });
  connect(list_, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
    if (item->data(Qt::UserRole).isValid())
      start(item->data(Qt::UserRole).toString(), secret_->text().toUtf8());
  });
  return box;
}

void ConnectDialog::fillRecents() {
  list_->clear();
  const QVector<RecentRobot> robots = recents_.list();
  for (const RecentRobot& robot : robots) {
    auto* item = new QListWidgetItem(list_);
    item->setData(Qt::UserRole, robot.address);
    item->setData(Qt::AccessibleTextRole, robot.address);
    item->setSizeHint({0, 28});
    auto* row = new QWidget(list_);
    auto* address = new PlainLabel(robot.address, row);
    auto* name = new PlainLabel(robot.name, row);
    name->setSecondary(true);
    auto* when = new PlainLabel(QLocale::c().toString(robot.last, QStringLiteral("yyyy-MM-dd HH:mm")), row);
    when->setSecondary(true);
    when->setAlignment(Qt::AlignRight);
    QToolButton* remove = iconButton(QStringLiteral("remove"), 14, tr("Forget this robot"), row,
                                     tr("Forget %1").arg(robot.address));
    address->setElideMode(Qt::ElideMiddle);
    name->setMaximumWidth(200);
    row->setLayout(rowOf({{address, 1}, name, when, remove}, 8, QMargins(8, 0, 4, 0)));
    name->setVisible(!robot.name.isEmpty());
    list_->setItemWidget(item, row);
    connect(remove, &QToolButton::clicked, this, [this, gone = robot.address] {
      recents_.remove(gone);
      // The button belongs to the removed row: not from within its own signal.
      QMetaObject::invokeMethod(this, &ConnectDialog::fillRecents, Qt::QueuedConnection);
    });
  }
  if (robots.isEmpty()) {
    auto* item = new QListWidgetItem(tr("None yet. Robots that you connect to are listed here."), list_);
    item->setFlags(Qt::NoItemFlags);
  }
}

void ConnectDialog::setAddress(const QString& address) {
  address_->setText(address);
  address_->selectAll();
}

void ConnectDialog::askForSecret(const QString& address, const QString& why) {
  address_->setText(address);
  setError(why.isEmpty() ? QString() : why.left(1).toUpper() + why.mid(1));
  secret_->clear();
  secret_->setFocus();
}

QString ConnectDialog::errorText() const { return error_->isHidden() ? QString() : error_->text(); }

void ConnectDialog::check() {
  connect_->setEnabled(!address_->text().trimmed().isEmpty());
  setError({});
}

void ConnectDialog::start(const QString& address, const QByteArray& secret) {
  const auto parsed = recents_.addresses().parse(address);
  if (!parsed) {
    setError(parsed.error());
    return;
  }
  if (const auto refusal = attempt_(parsed->text, secret)) {
    setError(*refusal);
    return;
  }
  accept();
}

void ConnectDialog::setError(const QString& sentence) {
  error_->setText(words::plainText(sentence));
  error_->setVisible(!sentence.isEmpty());
  if (!sentence.isEmpty()) {
    address_->setFocus();
    address_->selectAll();
  }
}

}  // namespace mapwright::window

#include "moc_connect_dialog.cpp"
