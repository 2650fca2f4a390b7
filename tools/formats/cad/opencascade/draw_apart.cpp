// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/draw_apart.h"

#include "files/Child_process.h"
#include "formats/cad/model_bytes.h"
#include "formats/cad/opencascade/Shape_drawing.h"

#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <string>
#include <utility>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

// The process passes this on for a face: its triangles, and the points of those of its edges that
// have none yet.
struct Face_drawing {
  Cad_mesh mesh;
  std::vector<std::pair<std::size_t, std::vector<GC::Cad_point<3>>>> edges;
};

} // namespace

template <> inline constexpr int number_of_members<Face_drawing> = 2;

namespace {

std::string seconds_text(double seconds) {
  std::ostringstream os;
  os.precision(3);
  os << seconds << " seconds of processor time";
  return os.str();
}

class Drawing_in_processes {
  const std::vector<TopoDS_Face>& faces_;
  const TopTools_IndexedMapOfShape& edges_;
  const Drawing_limits limits_;
  Shape_drawing drawing_;
  Model_drawing result_;
  std::vector<bool> has_edge_;
  double spent_ = 0; // seconds
  enum class Stage { together, divided, one_by_one } stage_ = Stage::together;
  std::map<const TopoDS_TShape*, std::string> failed_;

  // In the process apart: this process ends when it takes longer from now on.
  static void end_after(double seconds) {
    const double whole = std::floor(seconds);
    const itimerval time{
        {0, 0}, {static_cast<time_t>(whole), static_cast<suseconds_t>((std::max)(1., 1e6 * (seconds - whole)))}};
    ::setitimer(ITIMER_PROF, &time, nullptr);
  }

  // Writes the number of the bytes, and these.
  static void pass_on(int descriptor, const std::string& text) {
    const std::uint64_t size = text.size();
    const std::string bytes = std::string(reinterpret_cast<const char*>(&size), sizeof size) + text;
    for (std::size_t i = 0; i < bytes.size();) {
      const ssize_t n = ::write(descriptor, bytes.data() + i, bytes.size() - i);
      if (n < 0 && errno != EINTR) ::_exit(EXIT_FAILURE);
      if (n > 0) i += static_cast<std::size_t>(n);
    }
  }

  Face_drawing drawn(const TopoDS_Face& face) {
    Face_drawing result{drawing_.mesh(face), {}};
    for (TopExp_Explorer i(face, TopAbs_EDGE); i.More(); i.Next()) {
      const int number = edges_.FindIndex(i.Current());
      if (number == 0 || has_edge_[static_cast<std::size_t>(number - 1)]) continue;
      has_edge_[static_cast<std::size_t>(number - 1)] = true;
      result.edges.emplace_back(static_cast<std::size_t>(number - 1),
                                Shape_drawing::points(TopoDS::Edge(edges_(number).Oriented(TopAbs_FORWARD))));
    }
    return result;
  }

  [[noreturn]] void draw_from(std::size_t first, int descriptor, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(EXIT_FAILURE);
    std::signal(SIGPROF, SIG_DFL);
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    if (stage_ == Stage::together) {
      end_after(limits_.all / 2);
      drawing_.divide_together(faces_);
      pass_on(descriptor, {});
    }
    double left = limits_.all - spent_ - seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    for (std::size_t i = first; i < faces_.size(); ++i) {
      const double before = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
      end_after((std::min)(limits_.face, left));
      const bool has_failed = failed_.count(faces_[i].TShape().get()) != 0;
      Byte_writer bytes;
      bytes(has_failed ? Face_drawing() : drawn(faces_[i]));
      pass_on(descriptor, bytes.bytes());
      left -= seconds_of(CLOCK_PROCESS_CPUTIME_ID) - before;
    }
    ::_exit(EXIT_SUCCESS);
  }

  // Takes a face, or no bytes when all are divided.
  void take(const std::string& bytes) {
    if (bytes.empty()) {
      stage_ = Stage::divided;
      return;
    }
    Face_drawing face;
    Byte_reader reader(bytes);
    reader(face);
    const auto failed = failed_.find(faces_[result_.meshes.size()].TShape().get());
    if (failed != failed_.end()) face.mesh.reason = failed->second;
    result_.meshes.push_back(std::move(face.mesh));
    for (auto& [number, points] : face.edges) {
      if (has_edge_.at(number)) continue;
      has_edge_[number] = true;
      result_.edges[number] = std::move(points);
    }
  }

  // Takes what a process passes on, until it ends.
  void take_all(int descriptor) {
    std::string bytes;
    std::vector<char> buffer(std::size_t(1) << 16);
    for (ssize_t n; (n = ::read(descriptor, buffer.data(), buffer.size())) != 0;) {
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) return;
      bytes.append(buffer.data(), static_cast<std::size_t>(n));
      for (std::uint64_t size; bytes.size() >= sizeof size; bytes.erase(0, sizeof size + size)) {
        std::memcpy(&size, bytes.data(), sizeof size);
        if (bytes.size() - sizeof size < size) break;
        take(bytes.substr(sizeof size, size));
      }
    }
  }

  // Draws as many of the faces that are left as one process does, and returns why it has ended
  // before the last one.
  std::string draw_in_process() {
    Pipe pipe;
    const pid_t parent = ::getpid(), process = ::fork();
    if (process < 0) return std::strerror(errno);
    if (process == 0) draw_from(result_.meshes.size(), pipe[1], parent);
    pipe.close(1);
    take_all(pipe[0]);
    int status = 0;
    rusage usage{};
    while (::wait4(process, &status, 0, &usage) < 0 && errno == EINTR) {
    }
    for (const timeval& time : {usage.ru_utime, usage.ru_stime})
      spent_ += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF)
      return "dividing it into triangles does not end within " + seconds_text(limits_.face);
    return "OpenCASCADE crashes when it divides it into triangles";
  }

public:
  Drawing_in_processes(const std::vector<TopoDS_Face>& faces, const TopTools_IndexedMapOfShape& edges,
                       const Drawing_limits& limits)
      : faces_(faces), edges_(edges), limits_(limits), drawing_(faces),
        has_edge_(static_cast<std::size_t>(edges.Extent()), false) {
    result_.edges.resize(has_edge_.size());
  }

  Model_drawing draw() {
    while (result_.meshes.size() < faces_.size() && spent_ < limits_.all) {
      const std::string reason = draw_in_process();
      const bool is_of_face = stage_ != Stage::together;
      const std::size_t next = result_.meshes.size();
      stage_ = Stage::one_by_one;
      if (next == faces_.size() || spent_ >= limits_.all) break;
      if (!is_of_face) continue;
      failed_[faces_[next].TShape().get()] = reason;
      result_.meshes.emplace_back().reason = reason;
    }
    while (result_.meshes.size() < faces_.size())
      result_.meshes.emplace_back().reason =
          "the " + seconds_text((std::max)(0., limits_.all)) + " for all faces are used up";
    for (std::size_t i = 0; i < has_edge_.size(); ++i)
      if (!has_edge_[i])
        result_.edges[i] =
            Shape_drawing::points(TopoDS::Edge(edges_(static_cast<int>(i) + 1).Oriented(TopAbs_FORWARD)));
    return std::move(result_);
  }
};

} // namespace

Model_drawing draw_apart(const std::vector<TopoDS_Face>& faces, const TopTools_IndexedMapOfShape& edges,
                         const Drawing_limits& limits) {
  return Drawing_in_processes(faces, edges, limits).draw();
}
