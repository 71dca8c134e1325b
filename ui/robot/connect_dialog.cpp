#include "ui/robot/connect_dialog.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>
#include <QToolButton>

#include "robot/address.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/ui_colors.h"
#include "ui/robot/found_robots.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {

constexpr int kLargestPort = 65'535;

/// The user's colour, or the icon of a robot or file, in front of a row.
class RowMark : public QWidget {
 public:
  RowMark(const RecentRobot& robot, bool file, QWidget* parent)
      : QWidget(parent), color_(robotColor(robot.look.color)), file_(file) {
    setFixedSize(16, 16);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    if (color_.isValid()) return paintRobotColor(painter, QRectF(rect()).adjusted(2, 2, -2, -2), color_);
    paintIcon(&painter, QRectF(rect()), file_ ? QStringLiteral("map") : QStringLiteral("robot"),
              appColors().neutral);
  }

 private:
  QColor color_;
  bool file_;
};

/// Of a field that shares its row with others.
QLabel* labelFor(QWidget& field, const QString& text) {
  auto* const label = new QLabel(text, field.parentWidget());
  label->setBuddy(&field);
  return label;
}

}  // namespace

ConnectDialog::ConnectDialog(RecentRobots& recents, Attempt attempt, Probes probes, QWidget* parent)
    : QDialog(parent),
      recents_(recents),
      attempt_(std::move(attempt)),
      probes_(std::move(probes)),
      kind_(new QComboBox(this)),
      address_(new QLineEdit(this)),
      port_(new WholeBox(this)),
      encrypted_(new QCheckBox(tr("Encr&ypted (TLS)"), this)),
      made_(wrappedLabel({}, this)),
      secret_(new QLineEdit(this)),
      error_(wrappedLabel({}, this)),
      look_(this),
      below_(new QStackedWidget(this)),
      list_(new QListWidget(this)),
      found_(new FoundRobots(recents.addresses(), this)),
      connect_(new QPushButton(tr("Connect"), this)) {
  setWindowTitle(tr("Connect to a robot"));
  setMinimumWidth(640);
  auto* demo = new QPushButton(themedIcon(QStringLiteral("demo")), tr("Try the demo robot"), this);
  demo->setObjectName(QStringLiteral("secondary"));
  demo->setAutoDefault(false);
  auto* cancel = new QPushButton(tr("Cancel"), this);
  cancel->setObjectName(QStringLiteral("secondary"));
  cancel->setAutoDefault(false);
  connect_->setObjectName(QStringLiteral("primary"));
  connect_->setDefault(true);
  QWidget* const form = buildForm();
  recents_page_ = buildRecents();
  below_->addWidget(recents_page_);
  below_->addWidget(found_);
  setLayout(columnOf({form, {below_, 1}, rowOf({demo, LayoutItem::rest(), cancel, connect_}, 8)}, 12,
                     QMargins(16, 16, 16, 16)));

  connect(kind_, &QComboBox::currentIndexChanged, this, &ConnectDialog::chooseKind);
  connect(kind_, &QComboBox::activated, this, &ConnectDialog::splitAddress);
  connect(address_, &QLineEdit::textChanged, this, &ConnectDialog::check);
  connect(address_, &QLineEdit::textEdited, this, [this] {
    // A look that belongs to a robot does not go along to another one.
    const auto parsed = recents_.addresses().parse(address());
    if (look_.look() == RobotLook() || recents_.isLookOfOne(look_.look()))
      look_.setLook(parsed && !unknownHost() ? recents_.look(parsed->text) : RobotLook());
  });
  connect(port_, &QSpinBox::valueChanged, this, &ConnectDialog::check);
  // A number that is not taken changes only the text.
  connect(port_->findChild<QLineEdit*>(), &QLineEdit::textChanged, this, &ConnectDialog::check);
  connect(encrypted_, &QCheckBox::toggled, this, &ConnectDialog::check);
  connect(secret_, &QLineEdit::textEdited, this, [this] { setError({}); });
  connect(look_.name, &QLineEdit::editingFinished, this, &ConnectDialog::updateLook);
  connect(look_.color, &QComboBox::activated, this, &ConnectDialog::updateLook);
  connect(found_, &FoundRobots::changed, this, [this] {
    const auto found = found_->chosen();
    const bool looking = found_->looking();
    connect_->setText(found           ? tr("Connect")
                      : looking       ? tr("Stop")
                      : unknownHost() ? tr("Search")
                                      : tr("Connect"));
    if (found)
      secret_->setPlaceholderText(found->wants_secret ? tr("This robot asks for one")
                                                      : tr("Only if the robot asks for one"));
  });
  connect(found_, &FoundRobots::wanted, this,
          [this](const robot::FoundRobot& robot) { start(robot.address, secret_->text().toUtf8()); });
  connect(connect_, &QPushButton::clicked, this, &ConnectDialog::go);
  connect(demo, &QPushButton::clicked, this, [this] { start(QStringLiteral("demo:"), {}); });
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  fillRecents();
  chooseKind();
  address_->setFocus();
}

QWidget* ConnectDialog::buildForm() {
  auto* form_box = new QWidget(this);
  auto* form = new QFormLayout(form_box);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(4);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  kind_->setObjectName(QStringLiteral("kind"));
  kind_->addItem(probes_ ? tr("Find out what answers there") : tr("As its address says"), QString());
  for (const robot::AddressScheme& scheme : recents_.addresses().schemes()) {
    if (!scheme.title.isEmpty()) kind_->addItem(scheme.title, scheme.prefix);
  }
  address_->setObjectName(QStringLiteral("address"));
  address_->setPlaceholderText(QStringLiteral("192.0.2.7"));
  port_->setObjectName(QStringLiteral("port"));
  port_->setRange(1, kLargestPort);
  port_->setAccessibleName(tr("Port"));
  port_->setPrefix(tr("Port "));
  port_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  encrypted_->setObjectName(QStringLiteral("encrypted"));
  made_->setObjectName(QStringLiteral("made"));
  made_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  // The list below stays where it is while the hint changes: a double-click would miss it.
  made_->setFixedHeight(2 * made_->fontMetrics().lineSpacing());
  made_->setAlignment(Qt::AlignTop);
  setTextColor(*made_, appColors().secondary_text);
  secret_->setObjectName(QStringLiteral("secret"));
  secret_->setEchoMode(QLineEdit::Password);
  secret_->setPlaceholderText(tr("Only if the robot asks for one"));
  error_->setObjectName(QStringLiteral("error"));
  setTextColor(*error_, appColors().error_text);
  error_->hide();
  look_.name->setPlaceholderText(tr("What you call it, for example Dock 3"));
  form->addRow(tr("&Robot"), kind_);
  form->addRow(labelFor(*address_, tr("&Address")), rowOf({{address_, 1}, port_, encrypted_}, 8));
  form->addRow(QString(), columnOf({error_, made_}, 0));
  form->addRow(tr("&Secret"), secret_);
  form->addRow(labelFor(*look_.name, tr("&Name")), rowOf({{look_.name, 1}, look_.color}, 8));
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
    if (item) showRecent(item->data(Qt::UserRole).toString());
  });
  connect(list_, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
    if (item->data(Qt::UserRole).isValid())
      start(item->data(Qt::UserRole).toString(), secret_->text().toUtf8());
  });
  return box;
}

void ConnectDialog::showRecent(const QString& address) {
  if (address.isEmpty() || address == address_->text()) return;
  kind_->setCurrentIndex(0);
  address_->setText(address);
  look_.setLook(recents_.look(address));
  secret_->clear();  // it was typed for another robot
}

void ConnectDialog::fillRecents() {
  list_->clear();
  const QVector<RecentRobot> robots = recents_.list();
  for (const RecentRobot& robot : robots) {
    const RecentWords words = wordsOf(robot, recents_.addresses());
    auto* item = new QListWidgetItem(list_);
    item->setData(Qt::UserRole, robot.address);
    item->setData(Qt::AccessibleTextRole, words::listed({words.title, words.detail}));
    item->setSizeHint({0, 28});
    item->setToolTip(plainToolTip(robot.address));
    auto* row = new QWidget(list_);
    auto* title = new PlainLabel(words.title, row);
    auto* detail = new PlainLabel(words.detail, row);
    detail->setSecondary(true);
    detail->setElideMode(Qt::ElideMiddle);
    auto* when = new PlainLabel(QLocale::c().toString(robot.last, QStringLiteral("yyyy-MM-dd HH:mm")), row);
    when->setSecondary(true);
    when->setAlignment(Qt::AlignRight);
    QToolButton* remove = iconButton(QStringLiteral("remove"), 14,
                                     words.file ? tr("Forget this file") : tr("Forget this robot"), row,
                                     tr("Forget %1").arg(words.title));
    row->setLayout(rowOf({new RowMark(robot, words.file, row), {title, 1}, {detail, 1}, when, remove}, 8,
                         QMargins(8, 0, 4, 0)));
    list_->setItemWidget(item, row);
    connect(remove, &QToolButton::clicked, this, [this, gone = robot.address] {
      recents_.remove(gone);
      // The button belongs to the removed row: not from within its own signal.
      QMetaObject::invokeMethod(this, &ConnectDialog::fillRecents, Qt::QueuedConnection);
    });
  }
  if (robots.isEmpty()) {
    auto* item = new QListWidgetItem(tr("None yet. What you connect to or open is listed here."), list_);
    item->setFlags(Qt::NoItemFlags);
  }
}

void ConnectDialog::setAddress(const QString& address) {
  address_->setText(address);
  look_.setLook(recents_.look(address));
  address_->selectAll();
}

void ConnectDialog::askForSecret(const QString& address, const QString& why, const RobotLook& look) {
  kind_->setCurrentIndex(0);
  address_->setText(address);
  look_.setLook(look);
  setError(why.isEmpty() ? QString() : why.left(1).toUpper() + why.mid(1));
  secret_->clear();
  secret_->setFocus();
}

QString ConnectDialog::errorText() const { return error_->isHidden() ? QString() : error_->text(); }

const robot::AddressScheme* ConnectDialog::kind() const {
  const QString prefix = kind_->currentData().toString();
  for (const robot::AddressScheme& scheme : recents_.addresses().schemes()) {
    if (!prefix.isEmpty() && scheme.prefix == prefix) return &scheme;
  }
  return nullptr;
}

QString ConnectDialog::address() const {
  const QString typed = address_->text().trimmed();
  const robot::AddressScheme* const scheme = kind();
  if (!scheme || typed.isEmpty()) return typed;
  // A complete address says more than the fields beside it.
  auto host = recents_.addresses().bareHost(typed);
  if (!host) return typed;
  if (!host->port) host->port = port_->value();
  return robot::addressAt(*scheme, *host, host->encrypted || encrypted_->isChecked());
}

std::optional<robot::Host> ConnectDialog::unknownHost() const {
  return probes_ && !kind() ? recents_.addresses().bareHost(address_->text()) : std::nullopt;
}

void ConnectDialog::chooseKind() {
  const robot::AddressScheme* const scheme = kind();
  port_->setVisible(scheme != nullptr);
  encrypted_->setVisible(scheme != nullptr);
  if (scheme) port_->setValue(scheme->port);
  check();
}

void ConnectDialog::splitAddress() {
  const robot::AddressScheme* const scheme = kind();
  const robot::Addresses& addresses = recents_.addresses();
  const auto parsed = addresses.parse(address_->text());
  const bool whole = addresses.isAddress(address_->text()) && parsed && !parsed->url.host().isEmpty();
  if (!whole || (scheme ? scheme->prefix == parsed->scheme : !probes_)) return;
  // The usual port of another kind is not meant for this one.
  const QString host = addresses.hostShown(parsed->text);
  address_->setText(parsed->url.path().isEmpty() ? host : QStringLiteral("http://") + host);
  encrypted_->setChecked(parsed->url.scheme().endsWith(QLatin1Char('s')));
}

bool ConnectDialog::portBeyond() const { return !port_->isHidden() && port_->property("beyond").toBool(); }

QString ConnectDialog::hint(const QString& made, const std::optional<robot::Host>& host) const {
  if (portBeyond()) return tr("A port is a number from 1 to %1.").arg(kLargestPort);
  if (host) {
    const QString where =
        host->port ? robot::serverAt(QStringLiteral("http"), *host, *host->port).authority() : host->name;
    return tr("Searches for every kind of robot at %1. No secret is sent.").arg(where);
  }
  if (made.isEmpty())
    return kind() ? tr("The name or address of the robot's computer.")
                  : tr("A host such as 192.0.2.7 or dock-3.local:9090, or a full address such as %1.")
                        .arg(recents_.addresses().examples().value(0));
  const auto parsed = recents_.addresses().parse(made);
  if (!parsed) return {};
  const QString does =
      parsed->path.isEmpty() ? tr("Connects to %1").arg(parsed->text) : tr("Opens %1").arg(parsed->path);
  return kind() && kind()->prefix != parsed->scheme
             ? tr("%1. The address overrides the kind chosen above.").arg(does)
             : does;
}

void ConnectDialog::check() {
  if (found_->looking()) found_->stop();
  below_->setCurrentWidget(recents_page_);
  const QString made = address();
  const auto host = unknownHost();
  // What the address says itself is not asked for.
  const auto bare = recents_.addresses().bareHost(address_->text());
  const bool nothing = address_->text().trimmed().isEmpty();
  port_->setEnabled(nothing || (bare && !bare->port));
  encrypted_->setEnabled(nothing || (bare && !bare->encrypted));
  connect_->setEnabled(!made.isEmpty() && !portBeyond());
  connect_->setText(host ? tr("Search") : tr("Connect"));
  secret_->setPlaceholderText(tr("Only if the robot asks for one"));
  made_->setText(words::plainText(hint(made, host)));
  made_->setToolTip(plainToolTip(made_->text()));
  setError({});
}

void ConnectDialog::go() {
  if (below_->currentWidget() == found_) {
    if (const auto robot = found_->chosen()) return start(robot->address, secret_->text().toUtf8());
    if (found_->looking()) return found_->stop();
  }
  if (const auto host = unknownHost()) return search(*host);
  start(address(), secret_->text().toUtf8());
}

void ConnectDialog::search(const robot::Host& host) {
  setError({});
  below_->setCurrentWidget(found_);
  found_->look(address_->text().trimmed(), probes_(host));
}

void ConnectDialog::updateLook() {
  // A robot that is known keeps it at once; another one when it is connected to.
  const auto parsed = recents_.addresses().parse(address());
  if (unknownHost() || !parsed || look_.look() == recents_.look(parsed->text)) return;
  recents_.setLook(parsed->text, look_.look());
  fillRecents();
}

void ConnectDialog::start(const QString& address, const QByteArray& secret) {
  const auto parsed = recents_.addresses().parse(address);
  if (!parsed) {
    setError(parsed.error());
    return;
  }
  const bool demo = address == QLatin1String("demo:");
  // Fields that were left empty take nothing away from a robot that is known.
  const RobotLook typed = look_.look();
  const RobotLook look = typed == RobotLook() ? recents_.look(parsed->text) : typed;
  if (const auto refusal = attempt_({parsed->text, secret, demo ? RobotLook() : look})) {
    setError(*refusal);
    return;
  }
  accept();
}

void ConnectDialog::setError(const QString& sentence) {
  error_->setText(words::plainText(sentence));
  error_->setVisible(!sentence.isEmpty());
  made_->setVisible(sentence.isEmpty());
  if (!sentence.isEmpty()) {
    address_->setFocus();
    address_->selectAll();
  }
}

}  // namespace mapwright::ui

#include "moc_connect_dialog.cpp"
