#pragma once

namespace millwear::recorder {

/// Reaches a private member of a class of LIGGGHTS that has no other way in. The standard lets an
/// explicit instantiation name private members (C++20, 13.9.3/6), so one gives us a pointer to it:
///     struct Modules {
///       using Type = std::map<std::string, MeshModule*> FixMeshSurface::*;
///       friend Type member(Modules);
///     };
///     template struct Reach<Modules, &FixMeshSurface::active_mesh_modules>;
///     ... mesh.*member(Modules{}) ...
template <class Tag, typename Tag::Type pointer>
struct Reach {
  friend typename Tag::Type member(Tag) { return pointer; }
};

}  // namespace millwear::recorder
