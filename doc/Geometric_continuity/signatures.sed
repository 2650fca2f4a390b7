# Doxygen reads the output of this in place of a header: in signatures the types that a caller names, not those by which they are deduced. Each line of
# a header stays a line.
s/internal::Given_optional_number<\([A-Za-z_]*\)>/std::optional<\1>/g
s/internal::Convertible_number<\([A-Za-z_]*\)>/\1/g
s/const internal::Convertible_number<typename .*::FT>&/const FT\&/g
s/internal::Decision_FT<\([A-Za-z_]*\)>/typename Exact_field<Predicate_FT<\1>>::type/g
s/internal::Bezier_piece<typename std::iterator_traits<ForwardIterator>::value_type>/unspecified_type/g
s/internal::Bezier_coefficients<[A-Za-z_, ]*>/unspecified_type/g
s/= internal::usual_corner_threshold()/= Corner_threshold(5)/g
s/internal::Per_object_limit::default_steps/4'000'000'000/
/^using \| using \|constexpr /s/ = \(typename \)\{0,1\}internal::[^;]*;/ = unspecified_value;/
s/typedef \(std::conditional_t<.*\|typename \)internal::.*> *\(::type\)\{0,1\} \([A-Za-z_]*\);/typedef unspecified_type \3;/
s/internal::Traits_or_none<Traits_> Traits/Traits_ Traits/
s/internal::Unspecified/unspecified_type/g
s/internal::Continuity_of_model<PatchRange>/auto/
s/class = std::enable_if_t<internal::misses_[a-z]*<.*>>>$/class = unspecified_type>/
s/class Given = internal::Of_points/class Given = unspecified_type/
s/, class = internal::[A-Za-z_]*<[A-Za-z_, ]*>>/>/
s/typename internal::\(Chain_curve<InputIterator>\|Curve_of_range<Range>\)::Traits/Traits/g
s/typename internal::Blended_surfaces<[A-Za-z_, ]*>::Row_traits/unspecified_type/g
# doxygen gives the comment behind a using-declaration to the next member: functions become ones, types need none
s|^  using Base::beta; *///< r|  const FT\& beta() const; ///< R|
s|^  using Base::degree; *///< r|  int degree() const; ///< R|
s|^\( *using typename [^;=]*;\) *///<.*|\1|
s/^template <int k> inline constexpr internal::Parametric_join_predicate<k> \([a-z0-9_]*\){};/template <int k, class Left, class Right> bool \1(const Left\& left, const Right\& right);/
s/^inline constexpr internal::\(Join\|Polygon\)_predicate<.*> \([a-z0-9_]*\){};/template <class Left, class Right> bool \2(const Left\& left, const Right\& right);/
s/^inline constexpr internal::Invariant_predicate<.*> \([a-z0-9_]*\){};/template <class Left, class Right> std::optional<bool> \1(const Left\& left, const Right\& right);/
