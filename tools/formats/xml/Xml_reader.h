// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_XML_XML_READER_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_XML_XML_READER_H

#include "files/Unpacked_bytes.h"
#include "formats/xml/Xml_entities.h"

#include <CGAL/Geometric_continuity/Error.h>

#define XML_DTD // declares what Expat offers against entities that expand to more and more text
#include <expat.h>

#include <cstddef>
#include <exception>
#include <istream>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace GC = CGAL::Geometric_continuity;

// Reads an XML file with Expat; what derives from it receives the elements. The text may be packed
// by gzip. Entities are read when the file itself declares them and they expand to no more than
// 1 MiB, or ten times the length of the file; no other file is ever opened.
//
// Throws GC::Error with file, line and reason: `malformed_input` for what is not well-formed, for
// references to other entities, and for elements nested deeper than 256; `work_limit` for more than
// 256 MiB unpacked.
class Xml_reader {
  static constexpr std::size_t max_depth = 256;
  static constexpr int first_block = 1 << 16, last_block = 1 << 28; // bytes

  // Entities may expand to this many bytes, and a file that is longer to this many times its
  // length.
  static constexpr unsigned long long free_expansion = 1 << 20;
  static constexpr float max_expansion = 10;

  const std::string file_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  std::size_t depth_ = 0; // of the open elements
  Xml_entities entities_;
  bool has_doctype_ = false;
  std::exception_ptr error_;

  // No exception may pass through the parser, which is written in C.
  template <class Action> static void guarded(void* self, Action action) {
    Xml_reader& reader = *static_cast<Xml_reader*>(self);
    if (reader.error_) return;
    try {
      action(reader);
    } catch (...) {
      reader.error_ = std::current_exception();
      XML_StopParser(reader.parser_.get(), XML_FALSE);
    }
  }

  static void on_start(void* self, const XML_Char* name, const XML_Char** attributes) {
    guarded(self, [&](Xml_reader& reader) {
      // in attributes, Expat skips them in silence
      if (reader.has_doctype_) reader.refuse_if(reader.entities_.refusal_in(reader.piece()));
      if (reader.depth_ == max_depth) reader.refuse("elements are nested deeper than " + std::to_string(max_depth));
      ++reader.depth_;
      reader.start(name, attributes);
    });
  }
  static void on_end(void* self, const XML_Char*) {
    guarded(self, [](Xml_reader& reader) {
      --reader.depth_;
      reader.end();
    });
  }
  static void on_text(void* self, const XML_Char* text, int length) {
    guarded(self, [&](Xml_reader& reader) { reader.text(std::string_view(text, static_cast<std::size_t>(length))); });
  }
  static void on_instruction(void* self, const XML_Char* target, const XML_Char*) {
    guarded(self, [&](Xml_reader& reader) { reader.instruction(target); });
  }
  static void on_doctype(void* self, const XML_Char*, const XML_Char*, const XML_Char*, int) {
    static_cast<Xml_reader*>(self)->has_doctype_ = true;
  }
  static void on_entity(void* self, const XML_Char* name, int is_parameter, const XML_Char* value, int length,
                        const XML_Char*, const XML_Char*, const XML_Char*, const XML_Char*) {
    if (is_parameter != 0) return; // references to these are not followed
    guarded(self, [&](Xml_reader& reader) {
      if (value == nullptr) return reader.entities_.declare_external(name);
      reader.refuse_if(reader.entities_.declare(name, std::string_view(value, static_cast<std::size_t>(length))));
    });
  }
  // Called before the value is passed.
  static void on_default_value(void* self, const XML_Char*, const XML_Char*, const XML_Char*, const XML_Char* value,
                               int) {
    guarded(self, [&](Xml_reader& reader) {
      const std::string_view rest = reader.rest();
      if (value == nullptr || rest.size() < reader.length()) return;
      reader.refuse_if(reader.entities_.refusal_in_quoted(rest.substr(reader.length())));
    });
  }
  static void on_skipped_entity(void* self, const XML_Char* name, int) {
    guarded(self, [&](Xml_reader& reader) { reader.refuse_if(reader.entities_.refusal(name)); });
  }
  static int on_external_entity(XML_Parser parser, const XML_Char*, const XML_Char*, const XML_Char*, const XML_Char*) {
    guarded(XML_GetUserData(parser), [](Xml_reader& reader) {
      reader.refuse_if(reader.entities_.refusal_in(reader.piece()));
      reader.refuse("an entity stands in another file, which is not read");
    });
    return XML_STATUS_ERROR;
  }

  // Refuses what is not well-formed. Expat does not name the entity, which is the first one that is
  // not known.
  [[noreturn]] void refuse_error(XML_Error error) const {
    if (error == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
    if (error == XML_ERROR_UNDEFINED_ENTITY || error == XML_ERROR_ATTRIBUTE_EXTERNAL_ENTITY_REF)
      refuse_if(entities_.refusal_in(rest()));
    refuse(XML_ErrorString(error));
  }

  void refuse_if(const std::optional<std::string>& reason) const {
    if (reason) refuse(*reason);
  }

  // Returns the bytes that have been read from the place of the current call on.
  std::string_view rest() const {
    int offset = 0, size = 0;
    const char* const context = XML_GetInputContext(parser_.get(), &offset, &size);
    if (context == nullptr || size < offset) return std::string_view();
    return std::string_view(context + offset, static_cast<std::size_t>(size - offset));
  }

protected:
  // Receives the start of an element, with its attributes as pairs up to a null pointer; names are
  // behind their namespace and a blank where they have one.
  virtual void start(const std::string& name, const char** attributes) = 0;
  virtual void end() = 0;
  virtual void text(std::string_view) {}
  virtual void instruction(std::string_view) {}

  [[noreturn]] void refuse(const std::string& reason) const {
    throw GC::Error(GC::Error_code::malformed_input, file_ + ':' + std::to_string(line()) + ": " + reason);
  }
  const std::string& file() const { return file_; }
  long long line() const { return static_cast<long long>(XML_GetCurrentLineNumber(parser_.get())); }

  // The bytes of the file to which the current call refers, such as a tag.
  std::size_t length() const { return static_cast<std::size_t>(XML_GetCurrentByteCount(parser_.get())); }
  std::string_view piece() const { return rest().substr(0, length()); }

  // Where the current call begins in the file.
  std::size_t byte() const { return static_cast<std::size_t>(XML_GetCurrentByteIndex(parser_.get())); }

  explicit Xml_reader(const std::string& file)
      : file_(file), parser_(XML_ParserCreateNS(nullptr, ' '), XML_ParserFree) {
    if (!parser_) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), on_start, on_end);
    XML_SetCharacterDataHandler(parser_.get(), on_text);
    XML_SetProcessingInstructionHandler(parser_.get(), on_instruction);
    XML_SetStartDoctypeDeclHandler(parser_.get(), on_doctype);
    XML_SetEntityDeclHandler(parser_.get(), on_entity);
    XML_SetAttlistDeclHandler(parser_.get(), on_default_value);
    XML_SetSkippedEntityHandler(parser_.get(), on_skipped_entity);
    XML_SetExternalEntityRefHandler(parser_.get(), on_external_entity);
    XML_SetBillionLaughsAttackProtectionActivationThreshold(parser_.get(), free_expansion);
    XML_SetBillionLaughsAttackProtectionMaximumAmplification(parser_.get(), max_expansion);
  }

  // Reads all of it.
  void read(std::istream& stream) {
    Unpacked_bytes bytes(stream, file_);
    int size = first_block;
    XML_Index position = -1; // of the last tag that was begun
    for (bool last = false; !last;) {
      void* const block = XML_GetBuffer(parser_.get(), size);
      if (block == nullptr) throw std::bad_alloc();
      const std::size_t read = bytes.read(static_cast<char*>(block), static_cast<std::size_t>(size));
      last = read < static_cast<std::size_t>(size);
      const XML_Status status = XML_ParseBuffer(parser_.get(), static_cast<int>(read), last);
      if (error_) std::rethrow_exception(error_);
      if (status != XML_STATUS_OK) refuse_error(XML_GetErrorCode(parser_.get()));
      // a tag that is longer than a block is scanned again with the next one: longer blocks keep
      // that linear
      const XML_Index before = std::exchange(position, XML_GetCurrentByteIndex(parser_.get()));
      const bool stuck = position == before;
      if (stuck && size == last_block) refuse("a tag is longer than 256 MiB");
      size = stuck ? 2 * size : first_block;
    }
  }

public:
  Xml_reader(const Xml_reader&) = delete;
  Xml_reader& operator=(const Xml_reader&) = delete;
  virtual ~Xml_reader() = default;
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_XML_XML_READER_H
