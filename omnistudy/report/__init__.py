"""Figures and pages from Report objects; computes nothing."""
