// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace shading::report {

// A report in one HTML file that needs nothing beside it: style, script, plots and pictures are
// inside. Light or dark as the reader's system is, 1280 pixels wide at most, printable. Text is
// escaped here; markup comes from Table, Plot and PngImage.
class Page {
 public:
  // `facts` stand below the title: machine, version, command.
  Page(std::string title, std::vector<std::string> facts);

  void Section(std::string_view heading);  // also an entry of the contents
  void Subsection(std::string_view heading);
  void Text(std::string_view text);  // a paragraph
  void List(const std::vector<std::string>& items);
  void Command(std::string_view command);  // a line of the shell
  void Markup(std::string_view html);      // as it is
  // Plots or pictures side by side under one caption; the command reproduces them.
  void Figure(const std::vector<std::string>& pictures, std::string_view caption,
              std::string_view command);

  std::string Html() const;

 private:
  std::string title_;
  std::vector<std::string> facts_;
  std::vector<std::string> contents_;
  std::string body_;
};

}  // namespace shading::report
