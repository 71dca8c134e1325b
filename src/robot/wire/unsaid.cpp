#include "robot/wire/unsaid.h"

#include <algorithm>
#include <cctype>

#include <QJsonArray>
#include <QJsonDocument>

#include "net/plain_sentences.h"
#include "robot/wire/robot_link.h"

namespace mapwright::robot::wire {
namespace {

constexpr std::size_t kMacDigits = 65;  // a SHA-512 has 128, and may be cut off
constexpr const char* kInstead = "***";

void replaceAll(std::string& words, const std::string& form) {
  for (auto at = words.find(form); at != std::string::npos; at = words.find(form, at + 3))
    words.replace(at, form.size(), kInstead);
}

/// As JSON has it between its quotes.
QByteArray inJson(const QByteArray& secret) {
  const QByteArray json = QJsonDocument(QJsonArray{QString::fromUtf8(secret)}).toJson(QJsonDocument::Compact);
  return json.mid(2, json.size() - 4);
}

void replaceMacs(std::string& words) {
  const auto isHex = [](unsigned char c) { return std::isxdigit(c) != 0; };
  for (std::size_t at = 0; at + kMacDigits <= words.size();) {
    const auto from = words.begin() + std::ptrdiff_t(at);
    const auto end = std::find_if_not(from, words.end(), isHex);
    const auto digits = std::size_t(end - from);
    if (digits >= kMacDigits) {
      words.replace(at, digits, kInstead);
      at += 3;
    } else {
      at += digits + 1;
    }
  }
}

}  // namespace

Unsaid::Unsaid(const QByteArray& secret, std::size_t shortest) {
  if (secret.isEmpty() || std::size_t(secret.size()) < shortest) return;
  const QByteArray quoted = inJson(secret);
  for (const QByteArray& form :
       {secret, secret.toPercentEncoding(), secret.toBase64(),
        secret.toBase64(QByteArray::OmitTrailingEquals), secret.toHex(), quoted,
        QByteArray(quoted).replace('/', "\\/"), net::plainText(QString::fromUtf8(secret)).toUtf8()}) {
    if (!form.isEmpty() && std::size_t(form.size()) >= shortest) forms_.push_back(form.toStdString());
  }
  // One form may begin with another.
  std::sort(forms_.begin(), forms_.end(),
            [](const std::string& a, const std::string& b) { return a.size() > b.size(); });
}

void Unsaid::hideIn(std::string& words) const {
  for (const std::string& form : forms_) replaceAll(words, form);
  replaceMacs(words);
}

void Unsaid::hideIn(QString& words) const {
  std::string text = words.toStdString();
  hideIn(text);
  words = QString::fromStdString(text);
}

void Unsaid::hideIn(QByteArray& utf8) const {
  std::string text = utf8.toStdString();
  hideIn(text);
  if (text != utf8.toStdString()) utf8 = QByteArray::fromStdString(text);
}

void Unsaid::hideIn(Fault& fault) const {
  for (FaultArgument& argument : fault.arguments) {
    if (auto* words = std::get_if<std::string>(&argument)) hideIn(*words);
  }
  for (Fault& behind : fault.because) hideIn(behind);
}

void Unsaid::hideIn(map::Failure& failure) const {
  hideIn(failure.robot_code);
  hideIn(failure.detail);
  for (std::string& argument : failure.arguments) hideIn(argument);
  hideIn(failure.cause);
}

void Unsaid::hideIn(map::Problem& problem) const {
  hideIn(problem.reason);
  if (problem.request) hideIn(*problem.request);
}

void Unsaid::hideIn(ConnectionState& state) const { hideIn(state.reason); }

const Unsaid& unsaidOf(const QObject* link) {
  static const Unsaid nothing;
  const auto* const of = qobject_cast<const RobotLink*>(link);
  return of ? of->unsaid() : nothing;
}

}  // namespace mapwright::robot::wire
