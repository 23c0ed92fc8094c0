#pragma once

namespace stiction
{
  class ContactSurface;
  class MeshNames;
  class Parameters;

  /// Refuses a problem of which something is not said: a support, a load, a
  /// contact boundary, an obstacle, a law of friction with its number, a
  /// material. One sentence has the lines to write for all that is missing.
  ///
  /// @param boundaries those of the body, for the lines.
  ///
  /// Throws InputError.
  void require_complete(const Parameters &parameters, const MeshNames &boundaries);

  /// Refuses a problem in which nothing moves or loads the body: no entry does,
  /// see has_load() of the sections, and no obstacle is inside it. Unlike
  /// require_complete() it knows the gaps.
  ///
  /// Throws InputError.
  void require_load(const Parameters &parameters, const MeshNames &boundaries,
                    const ContactSurface &surface);
} // namespace stiction
