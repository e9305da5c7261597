"""The version of omnistudy, as stored with what it makes."""

VERSION = "0.1.0"
